// Writes the schema of scenes, and the tables of its document, from the lists of fields.

#include "Scene/Files/SmallFile.h"
#include "Scene/Json/SceneFormat.h"

#include <exception>
#include <fstream>
#include <iostream>
#include <string>

int main(int argc, char** argv)
{
  if (argc != 3)
  {
    std::cerr << "usage: WriteSceneFormat scene.schema.json SceneFormat.md\n";
    return 2;
  }
  try
  {
    const std::string document = varimarch::WithFieldTables(varimarch::BytesOfSmallFile(argv[2]));
    std::ofstream(argv[1]) << varimarch::SceneSchemaText();
    std::ofstream(argv[2]) << document;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
