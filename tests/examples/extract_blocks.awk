# Writes each block of a Markdown page that names a file, ```cpp path/of/file.h, to that file under the folder `out`.
/^```[a-z]+ [^ ]+$/ { file = out "/" $2; folder = file; sub("/[^/]*$", "", folder); system("mkdir -p '" folder "'"); printf "" > file; next }
/^```/ { if (file != "") close(file); file = ""; next }
file != "" { print > file }
