# Writes the axiom files into a C++ source, so that the library needs no file at run time.
# cmake -DFOLDER=... -DOUTPUT=... -P embed_axioms.cmake
file(GLOB_RECURSE files RELATIVE ${FOLDER} ${FOLDER}/*.smt2)
list(SORT files)
set(entries "")
foreach(file IN LISTS files)
  file(READ ${FOLDER}/${file} text)
  string(APPEND entries "      {\"${file}\", R\"smt2(${text})smt2\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"axioms/axiom_set.hpp\"

namespace asterism {

const std::map<std::string, std::string>& AxiomSet::built_in_files() {
  static const std::map<std::string, std::string> files{
${entries}  };
  return files;
}

}  // namespace asterism
")
