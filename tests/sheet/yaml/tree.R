# YAML files as lines: file and path, number or text, value. Lists stay lists: R would take one of one for a scalar.
walk <- function(path, value) {
  if (is.list(value)) {
    for (i in seq_along(value)) walk(paste0(path, "/", if (is.null(names(value))) i - 1 else names(value)[i]), value[[i]])
  } else if (is.numeric(value)) {
    bits <- writeBin(as.double(value), raw(), endian = "big")
    cat(path, "\tnumber\t", paste(as.character(bits), collapse = ""), "\n", sep = "")
  } else if (is.character(value)) {
    cat(path, "\ttext\t", gsub("\n", "\\n", value, fixed = TRUE), "\n", sep = "")
  } else {
    cat(path, "\t", class(value), "\t", format(value), "\n", sep = "")
  }
}
for (file in commandArgs(trailingOnly = TRUE)) walk(file, yaml::yaml.load_file(file, handlers = list(seq = as.list)))
