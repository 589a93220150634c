# Writes TABLE, the C++ source of ShaderFilesOfPackets() in Core/Packets/PacketTwins.h: the shader
# files that headers below FOLDER say they are twins of.
file(GLOB_RECURSE headers "${FOLDER}/*.h")
set(rows "")
foreach(header IN LISTS headers)
  file(READ "${header}" text)
  # The comment before the first line of code says it, perhaps over several lines.
  if(text MATCHES "// Twin of ([^#]*)")
    string(REGEX MATCHALL "[A-Za-z]+(/[A-Za-z]+)?[.]glsl" files "${CMAKE_MATCH_1}")
    foreach(file IN LISTS files)
      string(APPEND rows "    \"${file}\",\n")
    endforeach()
  endif()
endforeach()
file(WRITE "${TABLE}" "#include \"Core/Packets/PacketTwins.h\"

const std::set<std::string>& varimarch::ShaderFilesOfPackets()
{
  static const std::set<std::string> files = {
${rows}  };
  return files;
}
")
