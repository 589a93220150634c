#include "ReferenceSet.h"

#include "CommandLine/VtkMessages.h"
#include "Scene/OffscreenView.h"
#include "Scene/OutputFile.h"
#include "Scene/ProceduralVolume.h"
#include "Scene/ReferencePicture.h"
#include "Scene/SceneFile.h"
#include "Scene/SceneNames.h"
#include "Scene/VolumeWriters/VolumeWriters.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace varimarch
{

namespace
{

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

}

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

void WriteReferences(const std::string& folder, const OnStep& onStep)
{
  const std::filesystem::path path = folder;
  for (const JudgedScene& judged : JudgedScenes())
  {
    onStep(judged.name);
    LoadedVolume volume;
    volume.image = ProceduralVolume(SourceOf(judged));
    WriteVolume(volume, path / VolumeFileOf(judged));
    const auto drawn = DrawReferencePicture(judged.scene, volume.image, ReferenceTolerance);
    WriteFileWhole(path / (judged.name + ".npy"), NpyBytesOf(drawn->image));
    WriteFileWhole(path / (judged.name + ".json"),
      Described(judged, volume.image, drawn->largestError).dump(2) + "\n");
  }
}

void WritePicturesOf(MapperKind kind, const std::string& folder, const OnStep& onStep)
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
      WriteFileWhole(std::filesystem::path(folder) / (judged.name + ".npy"), NpyBytesOf(picture));
    }
  }
}

}
