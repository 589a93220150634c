// Errors in scenes: each names the file, the key, the expected value and the found one.

#include "Scene/Json/SceneFile.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

using namespace varimarch;

namespace
{

constexpr const char* BoneLook = R"("look": "ct-bone")";
constexpr const char* ShellsVolume = R"("volume": { "procedural": "shells" })";

std::string With(const std::string& more)
{
  return std::string("{") + ShellsVolume + ", " + BoneLook + ", " + more + "}";
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
    ErrorCase{ With(R"("camera": { "clippingRange": [20, 10] })"),
      "camera.clippingRange: expected the nearer distance first, found the farther one or two "
      "equal ones" },
    ErrorCase{ With(R"("lights": [ { "kind": "head" }, { "kind": "positional" } ])"),
      "lights[1]: expected the key \"position\", found none" },
    ErrorCase{ With(R"("lights": [ { "kind": "head", "direction": [0, 0, 1] } ])"),
      "lights[0]: unknown key \"direction\"; known: kind, color, intensity" },
    ErrorCase{ With(R"("lights": [ { "kind": "camera", "direction": [0, 0, 0] } ])"),
      "lights[0].direction: expected a vector towards the light, found one of length 0" },
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
      "volume: unknown key \"seed\"; known: file, series, kind, rectified, level, channel, raw, "
      "memory, "
      "time, timeSeconds, filesAreTimes" },
    ErrorCase{ R"({ "volume": { "procedural": "torsoo" }, "look": "ct-bone" })",
      "volume.procedural: unknown value \"torsoo\"; did you mean \"torso\"?" },
    ErrorCase{ R"({ "volume": { "procedural": "torso" }, "look": "ct-bones" })",
      "look: unknown preset \"ct-bones\"; did you mean \"ct-bone\"?" },
    ErrorCase{ R"({ "volume": { "procedural": "torso" }, "look": { "colors": [] } })",
      "look.colors: expected an array of 1 to 10000, found an array of 0" }));

TEST(SceneFileErrors, NodesMustBeInOrder)
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

TEST(SceneFileErrors, BrokenJsonNamesTheLine)
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

TEST(SceneFileErrors, MissingFileIsNamed)
{
  EXPECT_THROW(ReadScene("/no/such/scene.json"), std::runtime_error);
  EXPECT_THROW(ReadScene(VARIMARCH_SCENE_FOLDER), std::runtime_error);
}

}
