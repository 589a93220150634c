# Writes TABLE, the C++ source of ShaderTable() in March/Device/ShaderFiles.h: each .glsl file below
# FOLDER, as a raw string. Files change rarely and together, so that one source file serves all.
file(GLOB_RECURSE paths RELATIVE "${FOLDER}" "${FOLDER}/*.glsl")
set(rows "")
foreach(path IN LISTS paths)
  file(READ "${FOLDER}/${path}" text)
  string(APPEND rows "    { \"${path}\", R\"glsl(${text})glsl\" },\n")
endforeach()
file(WRITE "${TABLE}" "#include \"March/Device/ShaderFiles.h\"

const std::vector<varimarch::ShaderTableRow>& varimarch::ShaderTable()
{
  static const std::vector<ShaderTableRow> table = {
${rows}  };
  return table;
}
")
