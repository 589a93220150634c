// Measurements and annotations in scene files.

#include "Scene/Json/SceneFile.h"
#include "Scene/Measures/MeasureKinds.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>

using namespace varimarch;

namespace
{

TEST(MeasuresInFiles, OfEveryKindAreReadBackAsWritten)
{
  Scene scene;
  scene.volume = ProceduralSource();
  scene.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
  scene.look.opacities = { { 100.0, 0.0 }, { 300.0, 0.8 } };
  for (const MeasureTraits& traits : AllMeasureTraits())
  {
    Measure measure = { traits.kind, {}, traits.name };
    for (std::size_t i = 0; i < traits.fewestPoints; ++i)
    {
      measure.pointsMm.push_back({ double(i), 2.0, -0.5 });
    }
    measure.visible = traits.kind != MeasureKind::Arrow;
    scene.measures.push_back(measure);
  }
  const Scene back = SceneFromText(SceneText(scene), "test");
  ASSERT_EQ(back.measures.size(), scene.measures.size());
  for (std::size_t i = 0; i < back.measures.size(); ++i)
  {
    EXPECT_EQ(back.measures[i].kind, MeasureKind(i)) << "the table is in the order of the kinds";
    EXPECT_EQ(back.measures[i].pointsMm, scene.measures[i].pointsMm);
    EXPECT_EQ(back.measures[i].name, scene.measures[i].name);
    EXPECT_EQ(back.measures[i].visible, scene.measures[i].visible);
  }
}

TEST(MeasuresInFiles, AreReadFromOlderSessions)
{
  const Scene scene = SceneFromText(R"({ "volume": { "procedural": "torso" }, "look": "ct-bone",
    "distances": [{ "from": [1, 2, 3], "to": [4, 5, 6.5], "name": "length" }],
    "angles": [{ "from": [1, 2, 3], "vertex": [4, 5, 6.5], "to": [7, 8, 9] }],
    "boxes": [{ "from": [1, 2, 3], "to": [4, 5, 6.5] }] })",
    "test");
  ASSERT_EQ(scene.measures.size(), 3);
  EXPECT_EQ(scene.measures[0].name, "length");
  EXPECT_EQ(scene.measures[1].kind, MeasureKind::Angle);
  EXPECT_EQ(scene.measures[1].pointsMm[1], (std::array<double, 3>{ 4, 5, 6.5 }));
  EXPECT_EQ(scene.measures[2].kind, MeasureKind::Box);
}

TEST(MeasuresInFiles, AreReadBackHoweverManyAnOlderSessionHas)
{
  const auto listOf = [](const std::string& key, const std::string& element)
  {
    std::string list = ", \"" + key + "\": [" + element;
    for (int i = 1; i < 1000; ++i)
    {
      list += ',' + element;
    }
    return list + ']';
  };
  const Scene older = SceneFromText(R"({ "volume": { "procedural": "torso" }, "look": "ct-bone")" +
      listOf("distances", R"({ "from": [1, 2, 3], "to": [4, 5, 6] })") +
      listOf("angles", R"({ "from": [1, 2, 3], "vertex": [4, 5, 6], "to": [7, 8, 9] })") +
      listOf("boxes", R"({ "from": [1, 2, 3], "to": [4, 5, 6] })") + '}',
    "test");
  EXPECT_EQ(older.measures.size(), 3000);
  EXPECT_EQ(SceneFromText(SceneText(older), "test").measures.size(), 3000);
}

TEST(MeasuresInFiles, AreRefusedWithoutTheirPoints)
{
  EXPECT_THROW(SceneFromText(R"({ "volume": { "procedural": "torso" }, "look": "ct-bone",
      "measures": [{ "kind": "ellipse", "points": [[1, 2, 3], [4, 5, 6]] }] })",
                 "test"),
    std::runtime_error);
}

}
