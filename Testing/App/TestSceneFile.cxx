#include "Scene/Presets.h"
#include "Scene/SceneFile.h"
#include "Scene/SceneNames.h"
#include "Scene/Scissors.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace varimarch;

namespace
{

// A scene in which no value has its default.
Scene UnusualScene()
{
  Scene scene;
  scene.volume = FileSource{ "/data/scan.raw",
    RawLayout{ { 10, 20, 30 }, "float32", { 0.5, 0.25, 2.0 }, true, 352 }, "1.2.840.1", true };
  scene.look.name = "test";
  scene.look.description = "for a test";
  scene.look.domain = Domain::Relative;
  scene.look.colors = { { 0.1, { 0.25, 0.5, 0.75 }, { 0.25, 0.5 } }, { 0.1, { 1, 1, 1 }, {} } };
  scene.look.opacities = { { 0.3, 0.0, {} }, { 1.0 / 3.0, 0.7, { 0.75, 1.0 } } };
  scene.look.opacityUnitDistanceMm = 3.0;
  scene.look.shading = { false, 0.3, 0.4, 0.5, 60.0 };
  scene.look.blend = Blend::Isosurface;
  scene.look.gradientOpacities = { { 0.5, 0.25, { 0.25, 0.5 } }, { 2.0, 1.0 } };
  scene.look.isosurfaces = { { 0.5, { 0.1, 0.2, 0.3 }, 0.75 } };
  scene.look.averagedRange = { { 0.125, 0.75 } };
  scene.camera = { View::Inferior, -12.5, 33.0, 1.75, true, 42.0,
    CameraPose{ { 1.0, -2.5, 3.0 }, { 4.0, 5.0, 6.0 }, { 0.0, 0.0, 1.0 }, 80.0 } };
  scene.cuts = { { 0.1, 0.9, 0.0, 0.5, 0.25, 1.0 }, { { { 1.0, 2.0, 3.0 }, { 0.0, -1.0, 0.0 } } },
    { { scene.camera, { { 0.0, 0.5 }, { 1.0 / 3.0, 0.5 }, { 0.25, -0.5 } }, true } } };
  scene.slices = { { { 7.0, 8.0, 9.0 } }, { { 400.0, 40.0 } }, 5.0, SlabBlend::Mean };
  scene.distances = { { { 1.0, 2.0, 3.0 }, { 4.0, 5.0, 6.5 }, "length" } };
  scene.angles = { { { 1.0, 2.0, 3.0 }, { 4.0, 5.0, 6.5 }, { 7.0, 8.0, 9.0 }, "bend" } };
  scene.boxes = { { { 1.0, 2.0, 3.0 }, { 4.0, 5.0, 6.5 }, "liver" } };
  scene.labels = { "/data/organs.seg.nrrd", "1.2.840.2",
    { { 7, "liver", { 0.5, 0.25, 0.125 }, false, 0.75 }, { -2, "", { 0.0, 1.0, 0.5 } } } };
  scene.render = { 0.125, Acceleration::ScalarField, Integration::Simpson, 0.25, 3.5, 0.0 };
  scene.size = { 640, 360 };
  scene.background = { 0.1, 0.2, 0.3 };
  return scene;
}

constexpr const char* BoneLook = R"("look": "ct-bone")";
constexpr const char* ShellsVolume = R"("volume": { "procedural": "shells" })";

std::string With(const std::string& more)
{
  return std::string("{") + ShellsVolume + ", " + BoneLook + ", " + more + "}";
}

TEST(SceneFile, ReadsBackAsWritten)
{
  const Scene scene = UnusualScene();
  const std::string text = SceneText(scene);
  const Scene back = SceneFromText(text, "test");
  // Equal texts mean equal scenes, since the text holds everything. Check some values as well, in
  // case writing and reading omit the same key.
  EXPECT_EQ(SceneText(back), text);
  EXPECT_EQ(std::get<FileSource>(back.volume).raw->headerBytes, 352);
  EXPECT_EQ(std::get<FileSource>(back.volume).series, "1.2.840.1");
  EXPECT_TRUE(std::get<FileSource>(back.volume).rectified);
  EXPECT_EQ(back.look.opacities[1].value, 1.0 / 3.0);
  EXPECT_EQ(back.look.opacities[1].shape.midpoint, 0.75);
  EXPECT_EQ(back.look.colors[0].shape.sharpness, 0.5);
  EXPECT_EQ(back.look.domain, Domain::Relative);
  EXPECT_EQ(back.look.blend, Blend::Isosurface);
  EXPECT_EQ(back.camera.view, View::Inferior);
  EXPECT_TRUE(back.camera.parallel);
  ASSERT_TRUE(back.camera.pose);
  EXPECT_EQ(back.camera.pose->positionMm, scene.camera.pose->positionMm);
  EXPECT_EQ(back.camera.pose->focalPointMm, scene.camera.pose->focalPointMm);
  EXPECT_EQ(back.camera.pose->viewUp, scene.camera.pose->viewUp);
  EXPECT_EQ(back.camera.pose->parallelScaleMm, 80.0);
  EXPECT_EQ(back.cuts.box, scene.cuts.box);
  ASSERT_EQ(back.cuts.planes.size(), 1);
  EXPECT_EQ(back.cuts.planes[0].pointMm, scene.cuts.planes[0].pointMm);
  EXPECT_EQ(back.cuts.planes[0].normal, scene.cuts.planes[0].normal);
  EXPECT_EQ(back.slices.crosshairMm, scene.slices.crosshairMm);
  EXPECT_EQ(back.slices.windowLevel, scene.slices.windowLevel);
  EXPECT_EQ(back.slices.slabMm, 5.0);
  ASSERT_EQ(back.distances.size(), 1);
  EXPECT_EQ(back.distances[0].fromMm, scene.distances[0].fromMm);
  EXPECT_EQ(back.distances[0].toMm, scene.distances[0].toMm);
  EXPECT_EQ(back.render.sampleDistanceMm, 0.125);
  EXPECT_EQ(back.render.integration, Integration::Simpson);
  EXPECT_EQ(back.render.errorTolerance, 0.25);
  EXPECT_EQ(back.render.earlyTerminationTransmittance, 0.0);
  const RawLayout raw = std::get<FileSource>(back.volume).raw.value();
  EXPECT_TRUE(raw.bigEndian);
  EXPECT_EQ(raw.spacingMm[1], 0.25);
}

TEST(SceneFile, KeepsMeasurementsAndScissorsCuts)
{
  const Scene scene = UnusualScene();
  const Scene back = SceneFromText(SceneText(scene), "test");
  EXPECT_EQ(back.distances[0].name, "length");
  ASSERT_EQ(back.angles.size(), 1);
  EXPECT_EQ(back.angles[0].vertexMm, scene.angles[0].vertexMm);
  EXPECT_EQ(back.angles[0].name, "bend");
  ASSERT_EQ(back.boxes.size(), 1);
  EXPECT_EQ(back.boxes[0].fromMm, scene.boxes[0].fromMm);
  EXPECT_EQ(back.slices.slabBlend, SlabBlend::Mean);
  EXPECT_TRUE(back.cuts.scissors == scene.cuts.scissors);
}

TEST(SceneFile, KeepsLabels)
{
  const Scene back = SceneFromText(SceneText(UnusualScene()), "test");
  ASSERT_TRUE(back.labels);
  EXPECT_EQ(back.labels->path, "/data/organs.seg.nrrd");
  EXPECT_EQ(back.labels->series, "1.2.840.2");
  ASSERT_EQ(back.labels->segments.size(), 2);
  const Segment& liver = back.labels->segments[0];
  EXPECT_EQ(liver.name, "liver");
  EXPECT_EQ(liver.rgb, glm::dvec3(0.5, 0.25, 0.125));
  EXPECT_FALSE(liver.visible);
  EXPECT_EQ(liver.opacity, 0.75);
  EXPECT_EQ(back.labels->segments[1].value, -2);
}

TEST(SceneFile, OptionalPartsOfLooksReadBackAsWritten)
{
  const Scene scene = UnusualScene();
  const Scene back = SceneFromText(SceneText(scene), "test");
  ASSERT_EQ(back.look.gradientOpacities.size(), 2);
  EXPECT_EQ(back.look.gradientOpacities[0].opacity, 0.25);
  EXPECT_EQ(back.look.gradientOpacities[0].shape.midpoint, 0.25);
  ASSERT_EQ(back.look.isosurfaces.size(), 1);
  EXPECT_EQ(back.look.isosurfaces[0].value, 0.5);
  EXPECT_EQ(back.look.isosurfaces[0].rgb, glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(back.look.isosurfaces[0].opacity, 0.75);
  EXPECT_EQ(back.look.averagedRange, scene.look.averagedRange);
}

TEST(SceneFile, OverridesSettingsOfItsPreset)
{
  const Preset preset = { BuiltInPreset("ct-lung").look, 0.25, { { 0.5, 0.25, 0.75 } } };
  const std::string volume =
    R"({ "volume": { "procedural": "torso" }, "look": )" + PresetText(preset);
  const Scene taken = SceneFromText(volume + "}", "a.json");
  EXPECT_EQ(taken.render.errorTolerance, preset.errorTolerance);
  EXPECT_EQ(taken.background, preset.background);
  const Scene own = SceneFromText(
    volume + R"(, "background": [1, 0, 1], "render": { "errorTolerance": 0.5 } })", "a.json");
  EXPECT_EQ(own.background, (std::array{ 1.0, 0.0, 1.0 }));
  EXPECT_EQ(own.render.errorTolerance, 0.5);
  EXPECT_EQ(SceneFromText(volume + R"(, "render": {} })", "a.json").render.errorTolerance,
    preset.errorTolerance);
}

TEST(SceneFile, IsosurfaceBlendingRequiresIsosurfaces)
{
  const std::string look = R"({ "colors": [ { "value": 0, "rgb": [1, 1, 1] } ],
    "opacities": [ { "value": 0, "opacity": 1 } ], "blend": "isosurface" })";
  try
  {
    PresetFromText(look, "a.json");
    FAIL();
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ(error.what(),
      "a.json: the blend mode \"isosurface\" expects the key "
      "\"isosurfaces\", found none");
  }
}

TEST(SceneFile, MissingKeysHaveTheirDefaults)
{
  const Scene scene =
    SceneFromText(std::string("{") + ShellsVolume + ", " + BoneLook + "}", "test");
  const Scene defaults;
  EXPECT_EQ(scene.size, defaults.size);
  EXPECT_EQ(scene.camera.zoom, defaults.camera.zoom);
  EXPECT_EQ(scene.render.acceleration, defaults.render.acceleration);
  EXPECT_FALSE(scene.render.sampleDistanceMm);
  EXPECT_EQ(scene.look.name, "ct-bone");
}

struct ErrorCase
{
  std::string text;
  std::string message;
};

class SceneFileError : public testing::TestWithParam<ErrorCase>
{
};

TEST_P(SceneFileError, NamesTheFileTheKeyAndWhatWasExpected)
{
  try
  {
    SceneFromText(GetParam().text, "a.json");
    FAIL() << "read without complaint: " << GetParam().text;
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(error.what(), "a.json: " + GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(Messages, SceneFileError,
  testing::Values(ErrorCase{ "[]", "expected an object, found an array of 0" },
    ErrorCase{ "{}", "expected the key \"volume\", found none" },
    ErrorCase{ With(R"("camra": {})"), "unknown key \"camra\"; did you mean \"camera\"?" },
    ErrorCase{ With(R"("camera": { "azimut": 3 })"),
      "camera: unknown key \"azimut\"; did you mean \"azimuth\"?" },
    ErrorCase{ With(R"("camera": { "view": "front" })"),
      "camera.view: unknown value \"front\"; known: automatic, anterior, posterior, left, "
      "right, superior, inferior" },
    ErrorCase{
      With(R"("camera": { "zoom": "big" })"), "camera.zoom: expected a number > 0, found \"big\"" },
    ErrorCase{ With(R"("camera": { "elevation": 90 })"),
      "camera.elevation: expected a number > -90 and < 90, found 90" },
    ErrorCase{ With(R"("size": [512])"), "size: expected an array of 2, found an array of 1" },
    ErrorCase{ With(R"("size": [512, 1e9])"),
      "size[1]: expected a whole number from 1 to 16384, found 1000000000.0" },
    ErrorCase{ With(R"("background": [0, 0, 1.5])"),
      "background[2]: expected a number >= 0 and <= 1, found 1.5" },
    ErrorCase{ With(R"("render": { "sampleDistance": "fine" })"),
      "render.sampleDistance: expected a number > 0 or \"auto\", found \"fine\"" },
    ErrorCase{ With(R"("render": { "earlyTermination": 1 })"),
      "render.earlyTermination: expected a number >= 0 and < 1, found 1" },
    ErrorCase{
      With(R"("labels": { "segments": [] })"), "labels: expected the key \"file\", found none" },
    ErrorCase{
      With(R"("labels": { "file": "a", "segments": [ { "value": 0, "color": [0, 0, 0] } ] })"),
      "labels.segments[0].value: expected the value of a segment, found 0, which means no "
      "segment" },
    ErrorCase{ With(R"("labels": { "file": "a", "segments": [ { "value": 3, "color": [0, 0, 0] },
      { "value": 3, "color": [1, 0, 0] } ] })"),
      "labels.segments[1].value: expected another value for each segment, found 3 twice" },
    ErrorCase{ R"({ "volume": {}, "look": "ct-bone" })",
      "volume: expected the key \"file\" or \"procedural\", found neither" },
    ErrorCase{ R"({ "volume": { "file": "a.raw", "seed": 1 }, "look": "ct-bone" })",
      "volume: unknown key \"seed\"; known: file, series, rectified, raw" },
    ErrorCase{ R"({ "volume": { "procedural": "torsoo" }, "look": "ct-bone" })",
      "volume.procedural: unknown value \"torsoo\"; did you mean \"torso\"?" },
    ErrorCase{ R"({ "volume": { "procedural": "torso" }, "look": "ct-bones" })",
      "look: unknown preset \"ct-bones\"; did you mean \"ct-bone\"?" },
    ErrorCase{ R"({ "volume": { "procedural": "torso" }, "look": { "colors": [] } })",
      "look.colors: expected an array of 1 to 10000, found an array of 0" }));

TEST(SceneFile, NodesMustBeInOrder)
{
  try
  {
    PresetFromText(R"({ "colors": [ { "value": 1, "rgb": [0, 0, 0] } ],
      "opacities": [ { "value": 5, "opacity": 0 }, { "value": 4, "opacity": 1 } ] })",
      "look.json");
    FAIL();
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("look.json: opacities[1].value: expected nodes in"),
      std::string::npos)
      << error.what();
  }
}

TEST(SceneFile, BrokenJsonNamesTheLine)
{
  try
  {
    SceneFromText("{\n\"volume\": }", "a.json");
    FAIL();
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(std::string(error.what()).rfind("a.json: not valid JSON: ", 0), 0u) << error.what();
    EXPECT_NE(std::string(error.what()).find("line 2"), std::string::npos) << error.what();
  }
}

TEST(SceneFile, MissingFileIsNamed)
{
  EXPECT_THROW(ReadScene("/no/such/scene.json"), std::runtime_error);
  EXPECT_THROW(ReadScene(VARIMARCH_SCENE_FOLDER), std::runtime_error);
}

TEST(SceneFile, RelativeFilesStartAtTheScenesFolder)
{
  const std::filesystem::path folder = testing::TempDir();
  const std::string path = folder / "varimarch-relative.json";
  std::ofstream(path) << R"({ "volume": { "file": "sub/head.nii" }, "look": "mr-head",
    "labels": { "file": "sub/labels.nii" } })";
  EXPECT_EQ(std::get<FileSource>(ReadScene(path).volume).path, (folder / "sub/head.nii").string());
  EXPECT_EQ(ReadScene(path).labels->path, (folder / "sub/labels.nii").string());
  std::filesystem::remove(path);
}

TEST(SceneFile, EveryExampleIsReadable)
{
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(VARIMARCH_SCENE_FOLDER))
  {
    if (entry.path().filename() != "scene.schema.json")
    {
      EXPECT_NO_THROW(ReadScene(entry.path())) << entry.path();
      ++scenes;
    }
  }
  EXPECT_GE(scenes, 3);
}

// Requires that the schema has every written key, at its place.
void ExpectKeysInSchema(
  const nlohmann::json& value, const nlohmann::json& schema, const nlohmann::json& root)
{
  if (schema.contains("$ref"))
  {
    const std::string pointer = schema["$ref"].get<std::string>().substr(1);
    ExpectKeysInSchema(value, root.at(nlohmann::json::json_pointer(pointer)), root);
  }
  else if (schema.contains("oneOf") && value.is_object())
  {
    // Choose the branch that has the value's first key.
    for (nlohmann::json branch : schema["oneOf"])
    {
      if (branch.contains("$ref"))
      {
        const std::string pointer = branch["$ref"].get<std::string>().substr(1);
        branch = root.at(nlohmann::json::json_pointer(pointer));
      }
      if (branch.contains("properties") && branch["properties"].contains(value.begin().key()))
      {
        ExpectKeysInSchema(value, branch, root);
      }
    }
  }
  else if (value.is_object())
  {
    for (const auto& [key, member] : value.items())
    {
      ASSERT_TRUE(schema["properties"].contains(key)) << key;
      ExpectKeysInSchema(member, schema["properties"][key], root);
    }
  }
  else if (value.is_array())
  {
    for (const nlohmann::json& element : value)
    {
      ExpectKeysInSchema(element, schema.at("items"), root);
    }
  }
}

TEST(SceneFile, SchemaKnowsEveryBlend)
{
  std::ifstream file(std::string(VARIMARCH_SCENE_FOLDER) + "/scene.schema.json");
  const nlohmann::json schema = nlohmann::json::parse(file);
  const auto& known = schema["definitions"]["look"]["properties"]["blend"]["enum"];
  EXPECT_EQ(known.get<std::vector<std::string>>(), NamesOf(BlendNames()));
}

TEST(SceneFile, SchemaKnowsEveryPreset)
{
  std::ifstream file(std::string(VARIMARCH_SCENE_FOLDER) + "/scene.schema.json");
  const nlohmann::json schema = nlohmann::json::parse(file);
  std::vector<std::string> known = schema["properties"]["look"]["oneOf"][0]["enum"];
  std::vector<std::string> names = PresetNames();
  std::sort(known.begin(), known.end());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(known, names);
}

TEST(SceneFile, SchemaKnowsEveryKeyOfPresets)
{
  std::ifstream file(std::string(VARIMARCH_SCENE_FOLDER) + "/scene.schema.json");
  const nlohmann::json schema = nlohmann::json::parse(file);
  for (const std::string& name : PresetNames())
  {
    const std::string text = PresetText(BuiltInPreset(name));
    ExpectKeysInSchema(nlohmann::json::parse(text), schema["definitions"]["look"], schema);
  }
}

TEST(SceneFile, SchemaKnowsEveryKey)
{
  std::ifstream file(std::string(VARIMARCH_SCENE_FOLDER) + "/scene.schema.json");
  const nlohmann::json schema = nlohmann::json::parse(file);
  Scene scene = UnusualScene();
  ExpectKeysInSchema(nlohmann::json::parse(SceneText(scene)), schema, schema);
  scene.volume = ProceduralSource();
  ExpectKeysInSchema(nlohmann::json::parse(SceneText(scene)), schema, schema);
}

}
