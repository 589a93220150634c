#include "Scene/Volumes/Placing.h"

#include "Scene/Looks/Presets.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/WorldVector.h"

#include <vtkMatrix3x3.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace varimarch
{

glm::dmat4 WorldFromPatient(const Placement& placement, vtkImageData* image)
{
  const glm::dvec3 middle = VectorOf(MiddleOf(image));
  const glm::dvec3 turn = glm::radians(VectorOf(placement.turnDegrees));
  glm::dmat4 motion =
    glm::translate(glm::dmat4(1.0), VectorOf(placement.moveMm) + middle); // read from the right
  for (int axis = 2; axis >= 0; --axis)
  {
    motion = glm::rotate(motion, turn[axis], glm::dmat3(1.0)[axis]);
  }
  return glm::translate(motion, -middle);
}

std::vector<Measure> InPatientCoordinates(
  std::vector<Measure> measures, const Placement& placement, vtkImageData* image)
{
  const glm::dmat4 patientFromWorld = glm::inverse(WorldFromPatient(placement, image));
  for (Measure& measure : measures)
  {
    for (std::array<double, 3>& point : measure.pointsMm)
    {
      point = NumbersOf(glm::dvec3(patientFromWorld * glm::dvec4(VectorOf(point), 1.0)));
    }
  }
  return measures;
}

bool AreTurnedAlike(vtkImageData* first, vtkImageData* second)
{
  constexpr double MostDifference = 1e-4;
  const double* const axes = first->GetDirectionMatrix()->GetData();
  return std::equal(axes, axes + 9, second->GetDirectionMatrix()->GetData(),
    [](double a, double b) { return std::abs(a - b) < MostDifference; });
}

Placement PlacementOf(const glm::dmat4& worldFromPatient, vtkImageData* image)
{
  // The angles of a rotation about x, then y, then z. GLM counts columns first.
  const glm::dmat3 turned(worldFromPatient);
  const glm::dvec3 turn(std::atan2(turned[1][2], turned[2][2]),
    std::asin(std::clamp(-turned[0][2], -1.0, 1.0)), std::atan2(turned[0][1], turned[0][0]));
  const glm::dvec3 middle = VectorOf(MiddleOf(image));
  const glm::dvec3 moved(worldFromPatient * glm::dvec4(middle, 1.0));
  return { NumbersOf(glm::degrees(turn)), NumbersOf(moved - middle) };
}

vtkSmartPointer<vtkImageData> Placed(vtkImageData* image, const Placement& placement)
{
  if (placement == Placement())
  {
    return image;
  }
  const glm::dmat4 motion = WorldFromPatient(placement, image);
  const glm::dvec4 origin = motion * glm::dvec4(glm::make_vec3(image->GetOrigin()), 1.0);
  auto placed = vtkSmartPointer<vtkImageData>::New();
  placed->ShallowCopy(image);
  placed->SetOrigin(origin.x, origin.y, origin.z);
  // VTK stores matrices by rows, GLM by columns.
  const glm::dmat3 direction =
    glm::dmat3(motion) * glm::transpose(glm::make_mat3(image->GetDirectionMatrix()->GetData()));
  const glm::dmat3 rows = glm::transpose(direction);
  placed->SetDirectionMatrix(const_cast<double*>(glm::value_ptr(rows)));
  return placed;
}

namespace
{

// Projections cannot be drawn together with other volumes.
Look LookOver(const LoadedVolume& volume, const ImageStatistics& statistics)
{
  if (volume.modality == "PT")
  {
    return BuiltInPreset("pet-hot").look;
  }
  Look look = BuiltInPreset(SuggestedPreset(volume, statistics).name).look;
  return look.blend == Blend::Composite ? look : BuiltInPreset("mr-head").look;
}

}

CommonSpace SpaceOf(const LoadedVolume& first, const LoadedVolume& other)
{
  if (first.frameOfReference.empty() || other.frameOfReference.empty())
  {
    return CommonSpace::Unknown;
  }
  return first.frameOfReference == other.frameOfReference ? CommonSpace::Same
                                                          : CommonSpace::Different;
}

OverlaidVolume OverlayOf(
  const VolumeSource& source, const LoadedVolume& volume, const ImageStatistics& statistics)
{
  OverlaidVolume overlay = { source, InUnitsOfData(LookOver(volume, statistics), statistics) };
  if (const auto* const file = std::get_if<FileSource>(&source))
  {
    const std::filesystem::path path = file->path;
    overlay.name = (path.has_filename() ? path : path.parent_path()).filename().string();
  }
  overlay.name = volume.modality + (volume.modality.empty() ? "" : " ") + overlay.name;
  overlay.sliceColors = volume.modality == "PT" ? SliceColors::Hot : SliceColors::Gray;
  return overlay;
}

}
