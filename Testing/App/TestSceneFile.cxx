#include "Scene/Json/SceneFile.h"
#include "Scene/Json/SceneNames.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Model/SceneCuts.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace varimarch;

namespace
{

std::vector<OverlaidVolume> UnusualOverlays(const Look& look)
{
  return { { FileSource{ "/data/pet", std::nullopt, "1.2.840.3" }, look, "PET",
    { { 1.0, -2.0, 3.5 }, { 10.0, 20.0, -30.0 } }, false, 0.75, SliceColors::Green,
    { { 5.0, 2.5 } },
    SceneLabels{
      "/data/spots.nii", "1.2.840.4", { { 2, "spot", { 0.5, 0.25, 1.0 }, false, 0.75 } } } } };
}

std::vector<LookRegion> UnusualRegions()
{
  return { { RegionShape::Ellipse, { 0.25, 0.5 }, { 0.0, 2.0 }, { 0.1, 0.2, 0.3 }, 0.75, 0.125 },
    { RegionShape::Rectangle, { -1.0, 0.5 }, { 1.0, 2.0 }, { 1.0, 1.0, 1.0 } } };
}

// A scene in which no value has its default.
FileSource UnusualFile()
{
  return { "/data/scan.raw", RawLayout{ { 10, 20, 30 }, "float32", { 0.5, 0.25, 2.0 }, true, 352 },
    "1.2.840.1", true, 3.5, 3, 2, 0, 1.25, true };
}

Scene UnusualScene()
{
  Scene scene;
  scene.volume = UnusualFile();
  scene.look.name = "test";
  scene.look.description = "for a test";
  scene.look.domain = Domain::Relative;
  scene.look.colors = { { 0.1, { 0.25, 0.5, 0.75 }, { 0.25, 0.5 } }, { 0.1, { 1, 1, 1 }, {} } };
  scene.look.opacities = { { 0.3, 0.0, {} }, { 1.0 / 3.0, 0.7, { 0.75, 1.0 } } };
  scene.look.opacityUnitDistanceMm = 3.0;
  scene.look.shading = { false, 0.3, 0.4, 0.5, 60.0 };
  scene.look.dampingGradient = 0.375;
  scene.look.regions = UnusualRegions();
  scene.look.blend = Blend::Isosurface;
  scene.look.gradientOpacities = { { 0.5, 0.25, { 0.25, 0.5 } }, { 2.0, 1.0 } };
  scene.look.isosurfaces = { { 0.5, { 0.1, 0.2, 0.3 }, 0.75 } };
  scene.look.averagedRange = { { 0.125, 0.75 } };
  scene.camera = { View::Inferior, -12.5, 33.0, 1.75, true, 42.0,
    CameraPose{ { 1.0, -2.5, 3.0 }, { 4.0, 5.0, 6.0 }, { 0.0, 0.0, 1.0 }, 80.0 },
    { { 12.0, 340.5 } } };
  scene.lights = { { LightKind::Camera, { 1.0, 2.0, 3.0 }, {}, { 0.25, 0.5, 1.0 }, 2.5 },
    { LightKind::Directional, { 0.0, -1.0, 0.5 }, {}, { 1.0, 1.0, 1.0 }, 1.0, 7.5 },
    { LightKind::Positional, SceneLight().direction, { 4.0, 5.0, 6.0 } }, SceneLight() };
  scene.shadows = 0.6;
  scene.scattering = { 0.75, -0.25, 0.5 };
  scene.occlusion = { 0.25, 12.5 };
  scene.cuts = { { 0.1, 0.9, 0.0, 0.5, 0.25, 1.0 }, { { { 1.0, 2.0, 3.0 }, { 0.0, -1.0, 0.0 } } },
    { { scene.camera, { { 0.0, 0.5 }, { 1.0 / 3.0, 0.5 }, { 0.25, -0.5 } }, true } }, true, 12.5 };
  scene.slices = { { { 7.0, 8.0, 9.0 } }, { { 400.0, 40.0 } }, 5.0, SlabBlend::Mean,
    SliceFusion::Checkerboard, 0.25, { 10.0, -20.0, 30.0 }, 40.0 };
  scene.labels = { "/data/organs.seg.nrrd", "1.2.840.2",
    { { 7, "liver", { 0.5, 0.25, 0.125 }, false, 0.75 }, { -2, "", { 0.0, 1.0, 0.5 } } } };
  scene.overlays = UnusualOverlays(scene.look);
  scene.render = { 0.125, Acceleration::CellField, Integration::Simpson, 0.25, 3.5, 0.0,
    Interpolation::Cubic, VolumeLevel::Coarse, true, 2, 9, 3 };
  scene.size = { 640, 360 };
  scene.background = { 0.1, 0.2, 0.3 };
  return scene;
}

TEST(SceneFile, ReadsTheFileBackAsWritten)
{
  const Scene back = SceneFromText(SceneText(UnusualScene()), "test");
  const FileSource& file = std::get<FileSource>(back.volume);
  EXPECT_EQ(file.memoryMegabytes, 3.5);
  EXPECT_EQ(file.level, 3);
  EXPECT_EQ(file.channel, 2);
  EXPECT_EQ(file.timeSeconds, 1.25);
  EXPECT_TRUE(file.rectified.value() && file.filesAreTimes);
}

TEST(SceneFile, ReadsBackAsWritten)
{
  const Scene scene = UnusualScene();
  const std::string text = SceneText(scene);
  const Scene back = SceneFromText(text, "test");
  // Equal texts mean equal scenes, since the text holds everything. Check some values as well, in
  // case writing and reading omit the same key.
  EXPECT_EQ(SceneText(back), text);
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
  EXPECT_EQ(back.slices.turn, scene.slices.turn);
  EXPECT_EQ(back.slices.slabMm, 5.0);
  EXPECT_EQ(back.slices.curveTurnDegrees, 40.0);
  EXPECT_EQ(back.render.sampleDistanceMm, 0.125);
  EXPECT_EQ(back.render.integration, Integration::Simpson);
  EXPECT_EQ(back.render.errorTolerance, 0.25);
  EXPECT_EQ(back.render.earlyTerminationTransmittance, 0.0);
  const RawLayout raw = std::get<FileSource>(back.volume).raw.value();
  EXPECT_TRUE(raw.bigEndian);
  EXPECT_EQ(raw.spacingMm[1], 0.25);
}

TEST(SceneFile, KeepsScissorsCuts)
{
  const Scene scene = UnusualScene();
  const Scene back = SceneFromText(SceneText(scene), "test");
  EXPECT_EQ(back.slices.slabBlend, SlabBlend::Mean);
  EXPECT_TRUE(back.cuts.scissors == scene.cuts.scissors);
  EXPECT_TRUE(scene.cuts.bodyOnly);
  EXPECT_TRUE(back.cuts.bodyOnly);
  EXPECT_EQ(back.cuts.faceDepthMm, 12.5);
}

TEST(SceneFile, KeepsLightsAndHowTheyReflect)
{
  const Scene scene = UnusualScene();
  const Scene back = SceneFromText(SceneText(scene), "test");
  ASSERT_EQ(back.lights.size(), 4u);
  EXPECT_EQ(back.lights[0].kind, LightKind::Camera);
  EXPECT_EQ(back.lights[0].direction, scene.lights[0].direction);
  EXPECT_EQ(back.lights[0].rgb, scene.lights[0].rgb);
  EXPECT_EQ(back.lights[0].intensity, 2.5);
  EXPECT_EQ(back.lights[1].direction, scene.lights[1].direction);
  EXPECT_EQ(back.lights[1].softnessDegrees, 7.5);
  EXPECT_EQ(back.lights[2].positionMm, scene.lights[2].positionMm);
  EXPECT_EQ(back.lights[3].kind, LightKind::Head);
  EXPECT_EQ(back.shadows, 0.6);
  for (const double shadows : { 0.0, 1.0 })
  {
    Scene other = scene;
    other.shadows = shadows;
    EXPECT_EQ(SceneFromText(SceneText(other), "test").shadows, shadows);
  }
  EXPECT_EQ(back.scattering, scene.scattering);
  EXPECT_EQ(back.occlusion, scene.occlusion);
  Scene open = scene;
  open.occlusion = {};
  open.scattering = {};
  EXPECT_EQ(SceneFromText(SceneText(open), "test").scattering, Scattering());
  EXPECT_EQ(SceneFromText(SceneText(open), "test").occlusion, Occlusion());
  EXPECT_EQ(back.look.dampingGradient, 0.375);
}

TEST(SceneFile, KeepsRegionsOfValueAndGradient)
{
  const Scene scene = UnusualScene();
  const Scene back = SceneFromText(SceneText(scene), "test");
  ASSERT_EQ(back.look.regions.size(), 2u);
  EXPECT_EQ(back.look.regions[0].shape, RegionShape::Ellipse);
  EXPECT_EQ(back.look.regions[0].values, scene.look.regions[0].values);
  EXPECT_EQ(back.look.regions[0].gradients, scene.look.regions[0].gradients);
  EXPECT_EQ(back.look.regions[0].rgb, scene.look.regions[0].rgb);
  EXPECT_EQ(back.look.regions[0].opacity, 0.75);
  EXPECT_EQ(back.look.regions[0].softness, 0.125);
  EXPECT_EQ(back.look.regions[1].shape, RegionShape::Rectangle);
}

TEST(SceneFile, KeepsClippingRangeInterpolationAndJitter)
{
  const Scene scene = UnusualScene();
  const Scene back = SceneFromText(SceneText(scene), "test");
  EXPECT_EQ(back.camera.clippingRangeMm, scene.camera.clippingRangeMm);
  EXPECT_EQ(back.render.interpolation, Interpolation::Cubic);
  EXPECT_TRUE(back.render.jitter);
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

TEST(SceneFile, KeepsVolumesOverTheFirst)
{
  const Scene scene = UnusualScene();
  const Scene back = SceneFromText(SceneText(scene), "test");
  EXPECT_EQ(back.slices.fusion, SliceFusion::Checkerboard);
  EXPECT_EQ(back.slices.fusionOpacity, 0.25);
  ASSERT_EQ(back.overlays.size(), 1);
  const OverlaidVolume& overlay = back.overlays[0];
  EXPECT_EQ(std::get<FileSource>(overlay.source).series, "1.2.840.3");
  EXPECT_EQ(overlay.look.dampingGradient, 0.375);
  EXPECT_EQ(overlay.name, "PET");
  EXPECT_EQ(overlay.placement, scene.overlays[0].placement);
  EXPECT_FALSE(overlay.visible);
  EXPECT_EQ(overlay.opacity, 0.75);
  EXPECT_EQ(overlay.sliceColors, SliceColors::Green);
  EXPECT_EQ(overlay.windowLevel, scene.overlays[0].windowLevel);
  ASSERT_TRUE(overlay.labels);
  EXPECT_EQ(overlay.labels->path, "/data/spots.nii");
  EXPECT_EQ(overlay.labels->series, "1.2.840.4");
  EXPECT_EQ(overlay.labels->segments.at(0).name, "spot");
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
    SceneFromText(R"({ "volume": { "procedural": "shells" }, "look": "ct-bone" })", "test");
  const Scene defaults;
  EXPECT_EQ(scene.size, defaults.size);
  EXPECT_EQ(scene.camera.zoom, defaults.camera.zoom);
  EXPECT_EQ(scene.render.acceleration, defaults.render.acceleration);
  EXPECT_FALSE(scene.render.sampleDistanceMm);
  EXPECT_EQ(scene.look.name, "ct-bone");
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
