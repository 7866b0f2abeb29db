# The graph of derivations, for a page: larger labels, closer together; the caption is its legend.
/subgraph cluster_legend/,/^  }/d
s/ranksep=[0-9.]*; nodesep=[0-9.]*;/ranksep=0.12; nodesep=0.04; margin=0;/
s/fontsize=12/fontsize=24, height=0.1, width=0.1, margin="0.01,0.01"/
s/fontsize=10, height=0.2, margin="0.05,0.03"/fontsize=20, height=0.1, margin="0.02,0.01"/
