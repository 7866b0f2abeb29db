# The graph of derivations, for a page: larger labels; boxes hide the lines behind them; the caption is its legend.
/subgraph cluster_legend/,/^  }/d
s/ranksep=[0-9.]*; nodesep=[0-9.]*;/ranksep=0.24; nodesep=0.1; margin=0; edge [color="#555555"];/
s/fontsize=12/fontsize=28, height=0.1, width=0.1, margin="0.01,0.01", style=filled, fillcolor=white/
s/fontsize=10, height=0.2, margin="0.05,0.03"/fontsize=24, height=0.1, margin="0.06,0.03", fillcolor="#eeeeee"/
