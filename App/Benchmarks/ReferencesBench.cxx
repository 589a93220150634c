#include "Benchmark.h"
#include "CommandLine/OutputFolder.h"
#include "CommandLine/Parser.h"
#include "CommandLine/Progress.h"
#include "CommandLine/ReportedErrors.h"
#include "CommandLine/Truth.h"
#include "Scene/Files/OutputFile.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Json/SceneNames.h"
#include "Scene/Model/Scene.h"
#include "Scene/Reference/ReferencePicture.h"
#include "Scene/Volumes/ProceduralVolume.h"
#include "Scene/Volumes/VolumeWriters/VolumeWriters.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

namespace
{

/// A scene of Data/References, by which other renderers can be judged.
struct JudgedScene
{
  std::string name; ///< name of its files
  Scene scene;
};

constexpr int SideOfPictures = 64;

Scene SceneOf(ProceduralKind kind, const std::array<int, 3>& dimensions)
{
  Scene scene;
  scene.volume = ProceduralSource{ kind, dimensions, 1 };
  scene.camera.azimuthDegrees = 25.0;
  scene.camera.elevationDegrees = 15.0;
  scene.size = { SideOfPictures, SideOfPictures };
  scene.look.shading.enabled = false;
  return scene;
}

// Values from 0 to 255: the specifications' test volumes.
Scene TestVolume(ProceduralKind kind)
{
  Scene scene = SceneOf(kind, { 17, 17, 17 });
  scene.look.colors = { { 0.0, { 0.9, 0.3, 0.1 }, {} }, { 255.0, { 0.1, 0.5, 1.0 }, {} } };
  scene.look.opacities = { { 0.0, 0.004, {} }, { 255.0, 0.04, {} } };
  return scene;
}

Scene ShellsOf(const std::vector<OpacityNode>& opacities)
{
  Scene scene = SceneOf(ProceduralKind::Shells, { 40, 40, 40 });
  scene.look.colors = { { 60.0, { 0.2, 0.45, 0.7 }, {} }, { 240.0, { 0.95, 0.55, 0.2 }, {} } };
  scene.look.opacities = opacities;
  return scene;
}

Scene MarschnerLobbSurface(Blend blend)
{
  Scene scene = SceneOf(ProceduralKind::MarschnerLobb, { 32, 32, 32 });
  scene.look.colors = { { 0.5, { 0.85, 0.8, 0.7 }, {} } };
  scene.look.opacities = { { 0.48, 0.0, {} }, { 0.52, 0.9, {} } };
  scene.look.isosurfaces = { { 0.5, { 0.85, 0.8, 0.7 }, 1.0 } };
  scene.look.blend = blend;
  scene.look.shading.enabled = true;
  scene.camera.view = View::Superior;
  scene.camera.elevationDegrees = -40.0;
  return scene;
}

Scene TorsoBy(Blend blend, const std::vector<OpacityNode>& opacities)
{
  Scene scene = SceneOf(ProceduralKind::Torso, { 40, 36, 24 });
  scene.look.colors = { { -200.0, { 0.8, 0.5, 0.4 }, {} }, { 150.0, { 0.9, 0.3, 0.2 }, {} },
    { 400.0, { 1.0, 0.95, 0.85 }, {} } };
  scene.look.opacities = opacities;
  scene.look.blend = blend;
  return scene;
}

const std::vector<OpacityNode> soft = { { -200.0, 0.0, {} }, { 0.0, 0.01, {} }, { 150.0, 0.01, {} },
  { 400.0, 0.2, {} } };
const std::vector<OpacityNode> bone = { { 150.0, 0.0, {} }, { 250.0, 0.5, {} } };
const std::vector<OpacityNode> rising = { { -1000.0, 0.0, {} }, { 1200.0, 1.0, {} } };

Scene Lit(Scene scene)
{
  scene.look.shading.enabled = true;
  return scene;
}

Scene Parallel(Scene scene)
{
  scene.camera.parallel = true;
  return scene;
}

// From the spine into the chest.
Scene Inside(Scene scene)
{
  scene.camera.viewAngleDegrees = 60.0;
  scene.camera.pose =
    CameraPose{ { 5.0, -20.0, 10.0 }, { 0.0, 40.0, 0.0 }, { 0.0, 0.0, 1.0 }, 100.0 };
  return scene;
}

// The scenes of Data/References. All volumes are procedural.
std::vector<JudgedScene> JudgedScenes()
{
  const Scene torso = TorsoBy(Blend::Composite, soft);
  return {
    { "ramp", TestVolume(ProceduralKind::Ramp) },
    { "checkerboard", TestVolume(ProceduralKind::Checkerboard) },
    { "shells-hard-edge",
      ShellsOf({ { 89.0, 0.0, {} }, { 90.0, 0.08, {} }, { 240.0, 0.08, {} } }) },
    { "shells-thin-peak",
      ShellsOf({ { 118.0, 0.0, {} }, { 120.0, 0.9, {} }, { 122.0, 0.0, {} } }) },
    { "marschner-lobb-steep", MarschnerLobbSurface(Blend::Composite) },
    { "marschner-lobb-isosurface", MarschnerLobbSurface(Blend::Isosurface) },
    { "torso-soft", torso },
    { "torso-soft-lit", Lit(torso) },
    { "torso-bone-lit", Lit(TorsoBy(Blend::Composite, bone)) },
    { "torso-parallel", Parallel(torso) },
    { "torso-inside", Inside(torso) },
    { "torso-maximum", TorsoBy(Blend::MaximumIntensity, rising) },
    { "torso-average", TorsoBy(Blend::AverageIntensity, rising) },
    { "torso-additive", TorsoBy(Blend::Additive, { { -500.0, 0.0, {} }, { 500.0, 0.01, {} } }) },
  };
}

// Tolerance of the reference integrator; it estimates the error that it reaches.
constexpr double ReferenceTolerance = 1e-7;

const ProceduralSource& SourceOf(const JudgedScene& judged)
{
  return std::get<ProceduralSource>(judged.scene.volume);
}

std::string VolumeFileOf(const JudgedScene& judged)
{
  return NameOf(ProceduralNames(), SourceOf(judged).kind) + ".nrrd";
}

// All numbers that the rays depend on, in world space [mm].
nlohmann::ordered_json CameraNumbers(const Scene& scene, vtkImageData* image)
{
  ScenePipeline pipeline(scene, image, MapperKind::Varimarch);
  vtkCamera* const camera = pipeline.Renderer()->GetActiveCamera();
  const double aspect = double(scene.size[0]) / scene.size[1];
  vtkMatrix4x4* const matrix = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  nlohmann::ordered_json rows;
  for (int row = 0; row < 4; ++row)
  {
    rows.push_back(std::vector<double>(matrix->Element[row], matrix->Element[row] + 4));
  }
  const auto triple = [](const double* numbers)
  { return std::vector<double>(numbers, numbers + 3); };
  return { { "position", triple(camera->GetPosition()) },
    { "focalPoint", triple(camera->GetFocalPoint()) }, { "viewUp", triple(camera->GetViewUp()) },
    { "isParallel", scene.camera.parallel }, { "viewAngleDegrees", camera->GetViewAngle() },
    { "parallelScale", camera->GetParallelScale() },
    { "clippingRange", { camera->GetClippingRange()[0], camera->GetClippingRange()[1] } },
    { "clipFromWorld", rows } };
}

nlohmann::ordered_json Described(
  const JudgedScene& judged, vtkImageData* image, double largestError)
{
  const auto triple = [](const double* numbers)
  { return std::vector<double>(numbers, numbers + 3); };
  return { { "image", judged.name + ".npy" }, { "largestError", largestError },
    { "volume",
      { { "file", VolumeFileOf(judged) }, { "origin", triple(image->GetOrigin()) },
        { "spacing", triple(image->GetSpacing()) } } },
    { "camera", CameraNumbers(judged.scene, image) },
    { "scene", nlohmann::ordered_json::parse(SceneText(judged.scene)) } };
}

// The bytes of a NumPy file of a float image: height x width x 4, the top row first.
std::string NpyBytesOf(vtkImageData* floatPicture)
{
  const int* const size = floatPicture->GetDimensions();
  std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (" +
    std::to_string(size[1]) + ", " + std::to_string(size[0]) + ", 4), }";
  // Magic, version and length of the header take 10 bytes; all before the numbers is a multiple of
  // 64 bytes and ends with a line break.
  constexpr std::size_t Before = 10;
  header.append(63 - (Before + header.size()) % 64, ' ');
  header += '\n';
  std::string bytes = "\x93NUMPY\x01";
  bytes += '\0';
  bytes += char(header.size() & 0xff);
  bytes += char(header.size() >> 8);
  bytes += header;
  for (int row = size[1] - 1; row >= 0; --row)
  {
    const auto* const first = static_cast<const char*>(floatPicture->GetScalarPointer(0, row, 0));
    bytes.append(first, 4 * sizeof(float) * std::size_t(size[0]));
  }
  return bytes;
}

// Writes the reference's image of each scene as NAME.npy, all that a renderer must know to draw it
// as NAME.json, and each volume once as NRRD. Data/References/README.md describes the files.
// @throws std::runtime_error that names the file that cannot be written
void WriteReferences(const std::filesystem::path& folder, const OnStep& onStep)
{
  for (const JudgedScene& judged : JudgedScenes())
  {
    onStep(judged.name);
    LoadedVolume volume;
    volume.image = ProceduralVolume(SourceOf(judged));
    WriteVolume(volume, folder / VolumeFileOf(judged));
    const auto drawn = DrawReferencePicture(judged.scene, volume.image, ReferenceTolerance);
    WriteFileWhole(folder / (judged.name + ".npy"), NpyBytesOf(drawn->image));
    WriteFileWhole(folder / (judged.name + ".json"),
      Described(judged, volume.image, drawn->largestError).dump(2) + "\n");
  }
}

// Writes only the images, drawn by a mapper at its defaults.
// @throws std::runtime_error that names the file that cannot be written, or if the mapper reports
//         an error
void WritePicturesOf(MapperKind kind, const std::filesystem::path& folder, const OnStep& onStep)
{
  for (const JudgedScene& judged : JudgedScenes())
  {
    onStep(judged.name);
    if (CanBlend(kind, judged.scene.look.blend))
    {
      OffscreenView view(judged.scene, ProceduralVolume(SourceOf(judged)), kind);
      view.Render();
      const auto picture = view.FloatImage();
      ThrowIfVtkReportedError();
      WriteFileWhole(folder / (judged.name + ".npy"), NpyBytesOf(picture));
    }
  }
}

struct ReferencesOptions
{
  std::optional<MapperKind> renderer; ///< the mapper that draws; empty: the reference
};

void AddReferencesOptions(CLI::App& command, ReferencesOptions& options)
{
  command
    .add_option_function<std::string>(
      "--renderer",
      [&options](const std::string& name) { options.renderer = ValueOf(MapperKindNames(), name); },
      "The mapper that draws (default: the reference integrator)")
    ->check(OneOf(NamesOf(MapperKindNames())));
}

void RunReferences(const ReferencesOptions& options, BenchResults& results)
{
  SetInterruptNotice(results.Folder(), "some of the images");
  Progress progress("Drawing the scenes of the references");
  const auto onStep = [&](const std::string& step) { progress.SetActivity(step); };
  options.renderer ? WritePicturesOf(*options.renderer, results.Folder(), onStep)
                   : WriteReferences(results.Folder(), onStep);
}

}

Benchmark ReferencesBenchmark()
{
  Benchmark benchmark =
    MakeBenchmark("references", "Write reference images by which other renderers can be judged",
      "Writes NAME.npy and NAME.json of each scene, and the volumes as NRRD. With\n"
      "--renderer it writes only the images that this mapper draws.\n"
      "Examples:\n"
      "  varimarch-bench references -o Data/References\n"
      "  varimarch-bench references -o pictures --renderer vtk-gpu",
      AddReferencesOptions, RunReferences);
  benchmark.output = BenchOutput::FilesOfOtherKind;
  return benchmark;
}

}
