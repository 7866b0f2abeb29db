# README.md with its generated blocks made anew: where FOLDER has NAME.md, between <!-- NAME --> and <!-- end of NAME -->.
#     awk -v folder=build -f paper/readme.awk README.md
/^<!-- end of / { inside = 0 }
!inside
/^<!-- [a-z0-9]* -->$/ { while ((getline line < (folder "/" $2 ".md")) > 0) { print line; inside = 1 } }
