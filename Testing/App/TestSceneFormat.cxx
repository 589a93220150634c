// The files that are made from the lists of fields of a scene.

#include "Scene/Json/SceneFormat.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>

using namespace varimarch;

namespace
{

constexpr const char* Advice = "cmake --build --preset dev --target scene-format writes it anew";

std::string TextOf(const std::string& path)
{
  std::ifstream file(path);
  return { std::istreambuf_iterator<char>(file), {} };
}

TEST(SceneFormat, SchemaIsTheOneOfTheFields)
{
  EXPECT_EQ(TextOf(VARIMARCH_SCENE_FOLDER "/scene.schema.json"), SceneSchemaText()) << Advice;
}

TEST(SceneFormat, TablesAreThoseOfTheFields)
{
  const std::string document = TextOf(VARIMARCH_SCENE_FOLDER "/../../Documentation/SceneFormat.md");
  EXPECT_NE(document.find("| `zoom` | "), std::string::npos);
  EXPECT_EQ(document, WithFieldTables(document)) << Advice;
}

TEST(SceneFormat, TablesNameAStructAndEnd)
{
  EXPECT_THROW(WithFieldTables("<!-- fields: camra -->\n<!-- end -->\n"), std::runtime_error);
  EXPECT_THROW(WithFieldTables("<!-- fields: camera -->\n"), std::runtime_error);
}

TEST(SceneFormat, EachSettingHasAnOptionOfItsOwn)
{
  std::set<std::string> options;
  for (const SceneSetting& setting : SceneSettings())
  {
    EXPECT_TRUE(options.insert(setting.field.option).second) << setting.field.option;
  }
  EXPECT_EQ(options.count("--scattering-reach"), 1u);
  EXPECT_EQ(options.count("--shadow-strength"), 1u);
}

}
