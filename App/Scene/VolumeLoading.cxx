#include "Scene/VolumeLoading.h"

#include "Scene/ProceduralVolume.h"
#include "Scene/SceneNames.h"

#include <vtkCallbackCommand.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkVolumeFileReader.h>

#include <stdexcept>

namespace varimarch
{

namespace
{

void Apply(const RawLayout& raw, vtkVolumeFileReader* reader)
{
  reader->SetRawDimensions(raw.dimensions[0], raw.dimensions[1], raw.dimensions[2]);
  reader->SetRawScalarType(ValueOf(RawTypeNames(), raw.type));
  reader->SetRawSpacing(raw.spacingMm[0], raw.spacingMm[1], raw.spacingMm[2]);
  reader->SetRawBigEndian(raw.bigEndian);
}

// Passes progress on, and the answer back.
void Observe(vtkVolumeFileReader* reader, const LoadObserver& observer)
{
  vtkNew<vtkCallbackCommand> progress;
  progress->SetClientData(const_cast<LoadObserver*>(&observer));
  progress->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void* part)
    {
      if (!(*static_cast<const LoadObserver*>(client))(*static_cast<const double*>(part)))
      {
        static_cast<vtkVolumeFileReader*>(caller)->SetAbortExecute(1);
      }
    });
  reader->AddObserver(vtkCommand::ProgressEvent, progress);
}

LoadedVolume ReadFile(const FileSource& source, const LoadObserver& observer)
{
  vtkNew<vtkVolumeFileReader> reader;
  // The error goes on as an exception; an observer keeps VTK from reporting it as well.
  vtkNew<vtkCallbackCommand> nothing;
  nothing->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  reader->AddObserver(vtkCommand::ErrorEvent, nothing);
  reader->SetFileName(source.path.c_str());
  if (source.raw)
  {
    Apply(*source.raw, reader);
  }
  if (observer)
  {
    Observe(reader, observer);
  }
  reader->Update();
  if (reader->GetErrorCode() == vtkErrorCode::UserError)
  {
    throw std::runtime_error("Reading " + source.path + " was stopped");
  }
  if (reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw std::runtime_error(reader->GetErrorMessage());
  }
  LoadedVolume volume = { reader->GetOutput(), reader->GetModality(), {} };
  vtkStringArray* warnings = reader->GetWarnings();
  for (vtkIdType i = 0; i < warnings->GetNumberOfValues(); ++i)
  {
    volume.warnings.push_back(warnings->GetValue(i));
  }
  return volume;
}

}

LoadedVolume LoadVolume(const VolumeSource& source, const LoadObserver& observer)
{
  if (const auto* procedural = std::get_if<ProceduralSource>(&source))
  {
    const bool isCT = procedural->kind == ProceduralKind::Torso;
    return { ProceduralVolume(*procedural), isCT ? "CT" : "", {} };
  }
  return ReadFile(std::get<FileSource>(source), observer);
}

PresetSuggestion SuggestedPreset(const LoadedVolume& volume)
{
  constexpr double HighestAirHounsfield = -900.0;
  if (!volume.modality.empty())
  {
    return { volume.modality == "CT" ? "ct-bone" : "mr-head",
      "the file says that it is " + volume.modality };
  }
  if (volume.image->GetScalarRange()[0] <= HighestAirHounsfield)
  {
    return { "ct-bone", "its values go down to those of air in CT" };
  }
  return { "mr-head", "its values are not those of CT" };
}

}
