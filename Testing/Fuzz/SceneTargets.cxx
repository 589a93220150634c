// Scenes, which are also the viewer's sessions, and the names of raw files.
#include "Fuzz/FuzzInput.h"
#include "Fuzz/FuzzTarget.h"
#include "Fuzz/ReadInput.h"
#include "Scene/Json/RemoteMessage.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Volumes/RawGuess.h"

#include <algorithm>
#include <stdexcept>

namespace varimarch
{

namespace
{

const std::vector<std::string> SceneWords = { "\"volume\"", "\"file\"", "\"raw\"", "\"dimensions\"",
  "\"type\"", "\"spacing\"", "\"header\"", "\"procedural\"", "\"torso\"", "\"series\"",
  "\"rectify\"", "\"look\"", "\"ct-bone\"", "\"camera\"", "\"view\"", "\"anterior\"", "\"pose\"",
  "\"position\"", "\"focalPoint\"", "\"viewUp\"", "\"parallel\"", "\"zoom\"", "\"cuts\"", "\"box\"",
  "\"planes\"", "\"scissors\"", "\"outline\"", "\"keep\"", "\"slices\"", "\"crosshair\"",
  "\"windowLevel\"", "\"slab\"", "\"distances\"", "\"angles\"", "\"boxes\"", "\"from\"", "\"to\"",
  "\"render\"", "\"integration\"", "\"auto\"", "\"size\"", "\"background\"", "\"colors\"",
  "\"opacities\"", "\"gradientOpacities\"", "\"isosurfaces\"", "\"blend\"", "\"domain\"",
  "\"relative\"", "\"shading\"", "\"damping\"", "\"lights\"", "\"positional\"", "\"direction\"",
  "\"clippingRange\"", "\"interpolation\"", "1e308", "1e-320", "-0.0", "null", "\\u0000",
  "\\ud800" };

/// A scene that uses every key.
Scene FullScene()
{
  Scene scene;
  scene.volume = FileSource{ "head.raw", RawLayout{ { 2, 3, 4 }, "float32" }, "1.2", true };
  scene.look = BuiltInPreset("ct-bone").look;
  scene.look.gradientOpacities = { { 0.0, 0.0 }, { 100.0, 1.0, { 0.25, 0.5 } } };
  scene.look.regions = { { RegionShape::Ellipse, { 0, 300 }, { 5, 40 }, { 1, 0, 0 } },
    { RegionShape::Rectangle, { 0, 300 }, { 0, 40 }, { 0, 1, 0 }, 0.25, 0.0 } };
  scene.look.dampingGradient = 12.5;
  scene.lights = { { LightKind::Camera, { 1, 1, 1 } }, { LightKind::Positional } };
  scene.look.isosurfaces = { { 300.0, { 1.0, 0.5, 0.0 }, 0.5 } };
  scene.look.averagedRange = { { -100.0, 100.0 } };
  scene.camera.pose = CameraPose{ { 0, -500, 0 }, { 0, 0, 0 }, { 0, 0, 1 }, 100.0 };
  scene.cuts.planes = { { { 1, 2, 3 }, { 0, 0, 1 } } };
  scene.cuts.scissors = { { scene.camera, { { -0.5, 0.0 }, { 0.5, 0.0 }, { 0.0, 0.5 } }, true } };
  scene.camera.clippingRangeMm = { { 10.0, 20.0 } };
  scene.slices.crosshairMm = { { 1.0, 2.0, 3.0 } };
  scene.slices.windowLevel = { { 400.0, 40.0 } };
  scene.measures = { { MeasureKind::Distance, { { 0, 0, 0 }, { 1, 1, 1 } }, "a \"name\"" },
    { MeasureKind::Ellipse, { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 0, 0 } }, "", false },
    { MeasureKind::Curve, { { 0, 0, 0 } } } };
  return scene;
}

std::vector<std::string> SceneSeeds()
{
  Scene procedural;
  procedural.volume = ProceduralSource{ ProceduralKind::Torso, { 16, 16, 16 }, 7 };
  procedural.look = BuiltInPreset("mr-head").look;
  return { SceneText(FullScene()), SceneText(procedural),
    R"({ "volume": { "file": "a.nii.gz" }, "look": "mr-head", "camera": { "view": "left" } })" };
}

std::vector<std::string> PresetSeeds()
{
  std::vector<std::string> seeds;
  for (const char* const name : { "ct-bone", "mr-head", "ct-maximum", "ct-implants" })
  {
    seeds.push_back(PresetText(BuiltInPreset(name)));
  }
  return seeds;
}

/// Reads a text, and requires that writing and reading what was read changes nothing.
template <class Read, class Write>
bool RequireThatTextsReadBack(const std::string& text, Read read, Write write)
{
  std::string written;
  try
  {
    written = write(read(text, "a.json"));
  }
  catch (const std::runtime_error& error)
  {
    RequireOneLine(error.what());
    Require(std::string(error.what()).find("a.json") != std::string::npos,
      "the error does not name the file: " + std::string(error.what()));
    return false;
  }
  Require(write(read(written, "a.json")) == written, "what was read reads back otherwise");
  return true;
}

/// Requests that a viewer grants, the first with every key of looks.
std::vector<std::string> RemoteSeeds()
{
  std::string look = LookText(FullScene().look);
  std::replace(look.begin(), look.end(), '\n', ' ');
  return { R"({ "set": )" + look + "}", R"({ "set": "ct-bone" })", R"({ "get": "look" })",
    R"({ "get": "status" })" };
}

/// Requires that a request is read, or refused in one line, and that its look can be answered in
/// one.
bool ReadRequest(const std::string& text)
{
  try
  {
    const RemoteRequest request = RemoteRequestFromText(text);
    const bool setsLook = request.task == RemoteRequest::Task::SetLook;
    const std::string answer = setsLook ? RemoteLook(request.look) : RemoteDone();
    RequireOneLine(answer);
    return true;
  }
  catch (const std::runtime_error& error)
  {
    RequireOneLine(error.what());
    RequireOneLine(RemoteError(error.what()));
    return false;
  }
}

/// The first line is the name of a file, the rest its voxels.
bool GuessAndRead(const std::string& input)
{
  const std::size_t lineEnd = std::min(input.find('\n'), input.size());
  std::string name = input.substr(0, std::min<std::size_t>(lineEnd, 200)) + ".raw";
  std::replace_if(
    name.begin(), name.end(), [](char letter) { return letter == '/' || letter == '\0'; }, '_');
  Inputs().Replace({ name }, input.substr(std::min(lineEnd + 1, input.size())));
  const std::string path = Inputs().Path(name);
  const auto byteCount = std::int64_t(input.size()) - std::int64_t(lineEnd) - 1;
  const RawLayout layout = GuessedRawLayout(path, std::max<std::int64_t>(byteCount, 0));
  Require(
    std::all_of(layout.dimensions.begin(), layout.dimensions.end(), [](int n) { return n >= 1; }),
    "a guessed dimension is not >= 1");
  Require(BytesOf(layout) > 0, "a guessed layout has no voxels");
  IsBareVoxels(path);
  return ReadInput(path, &layout);
}

std::vector<std::string> RawSeeds()
{
  return { "head_5x4x3_int16\n" + std::string(120, 'v'), "head_float32\n" + std::string(32, 'v'),
    "head\n" + std::string(27, 'v') };
}

}

std::vector<FuzzTarget> SceneTargets()
{
  const auto scene = [](const std::string& text)
  {
    const bool isScene = RequireThatTextsReadBack(text, SceneFromText, SceneText);
    // Other callers have the volume already.
    try
    {
      SceneWithoutVolumeFromText(text, "a.json");
      return true;
    }
    catch (const std::runtime_error& error)
    {
      RequireOneLine(error.what());
      return isScene;
    }
  };
  const auto preset = [](const std::string& text)
  { return RequireThatTextsReadBack(text, PresetFromText, PresetText); };
  return { { "scene", scene, SceneSeeds, SceneWords },
    { "preset", preset, PresetSeeds, SceneWords } };
}

FuzzTarget RemoteTarget()
{
  std::vector<std::string> words = SceneWords;
  words.insert(words.end(), { "\"get\"", "\"set\"", "\"status\"", "\"regions\"", "\"ellipse\"" });
  return { "remote", ReadRequest, RemoteSeeds, words };
}

FuzzTarget RawGuessTarget()
{
  return { "raw-guess", GuessAndRead, RawSeeds,
    { "256x256x108", "1x1x1", "99999x99999x99999", "uint8", "int16", "uint32", "int64", "float32",
      "float64", "\n" } };
}

}
