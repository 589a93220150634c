# Writes TABLE, the C++ source of FUNCTION, which HEADER declares with the result of ShaderTable() in
# March/Device/ShaderFiles.h. It has each .glsl file below FOLDER as a raw string. One source file for all is enough, because they change rarely and
# together.
file(GLOB_RECURSE paths RELATIVE "${FOLDER}" "${FOLDER}/*.glsl")
set(rows "")
foreach(path IN LISTS paths)
  file(READ "${FOLDER}/${path}" text)
  string(APPEND rows "    { \"${path}\", R\"glsl(${text})glsl\" },\n")
endforeach()
file(WRITE "${TABLE}" "#include \"${HEADER}\"

const std::vector<varimarch::ShaderTableRow>& varimarch::${FUNCTION}()
{
  static const std::vector<ShaderTableRow> table = {
${rows}  };
  return table;
}
")
