#include "Readers/DicomSlices.h"

#include "Readers/FileError.h"

#include <vtkDICOMDictHash.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMReader.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <glm/geometric.hpp>
#include <glm/mat2x3.hpp>

#include <algorithm>
#include <filesystem>

namespace varimarch
{
namespace
{

/// Files whose slices have the same direction.
struct Direction
{
  glm::dmat2x3 axes;
  std::vector<std::string> paths;
};

/// Directions of the rows and columns of a file's images; 0 if the file does not state them in one
/// place.
glm::dmat2x3 AxesOf(vtkDICOMMetaData* meta, int file)
{
  glm::dmat2x3 axes(0.0);
  const vtkDICOMValue& value = meta->Get(file, DC::ImageOrientationPatient);
  if (value.GetNumberOfValues() == 6)
  {
    value.GetValues(&axes[0][0], 6);
  }
  return axes;
}

bool IsNear(const glm::dmat2x3& a, const glm::dmat2x3& b)
{
  constexpr double LargestDifference = 0.01;
  return glm::distance(a[0], b[0]) < LargestDifference &&
    glm::distance(a[1], b[1]) < LargestDifference;
}

}

int SliceCount(vtkDICOMReader* reader)
{
  return int(reader->GetFileIndexArray()->GetNumberOfTuples());
}

const vtkDICOMValue& SliceValue(vtkDICOMReader* reader, int slice, vtkDICOMTag tag)
{
  const int file = int(reader->GetFileIndexArray()->GetComponent(slice, 0));
  const int frame = int(reader->GetFrameIndexArray()->GetComponent(slice, 0));
  return reader->GetMetaData()->Get(file, frame, tag);
}

std::string SliceFileName(vtkDICOMReader* reader, int slice)
{
  const int file = int(reader->GetFileIndexArray()->GetComponent(slice, 0));
  return FileName(reader->GetFileNames()->GetValue(file));
}

std::string FileName(const std::string& path)
{
  return std::filesystem::path(path).filename().string();
}

std::string FileList(const std::vector<std::string>& names)
{
  constexpr std::size_t MostNamed = 2;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), MostNamed); ++i)
  {
    text += (i > 0 ? ", " : "") + Quoted(names[i]);
  }
  return names.size() <= MostNamed
    ? text
    : text + " and " + std::to_string(names.size() - MostNamed) + " others";
}

void KeepOneDirection(vtkDICOMReader* reader, std::vector<std::string>& warnings)
{
  std::vector<Direction> directions;
  vtkStringArray* const files = reader->GetFileNames();
  for (int file = 0; file < int(files->GetNumberOfValues()); ++file)
  {
    const glm::dmat2x3 axes = AxesOf(reader->GetMetaData(), file);
    auto known = std::find_if(directions.begin(), directions.end(),
      [&](const Direction& direction) { return IsNear(direction.axes, axes); });
    known = known == directions.end() ? directions.insert(known, { axes, {} }) : known;
    known->paths.push_back(files->GetValue(file));
  }
  const auto isFewer = [](const Direction& a, const Direction& b)
  { return a.paths.size() < b.paths.size(); };
  const auto most = std::max_element(directions.begin(), directions.end(), isFewer);
  std::vector<std::string> leftOut;
  vtkNew<vtkStringArray> kept;
  for (auto direction = directions.begin(); direction != directions.end(); ++direction)
  {
    for (const std::string& path : direction->paths)
    {
      direction == most ? void(kept->InsertNextValue(path)) : leftOut.push_back(FileName(path));
    }
  }
  if (!leftOut.empty())
  {
    reader->SetFileNames(kept);
    warnings.push_back(
      "Images were left out because their direction differs from that of the others: " +
      FileList(leftOut) + ".");
  }
}

void WarnOfLoss(vtkDICOMReader* reader, std::vector<std::string>& warnings)
{
  std::vector<std::string> lossy;
  for (int slice = 0; slice < SliceCount(reader); ++slice)
  {
    if (SliceValue(reader, slice, DC::LossyImageCompression).AsString() == "01")
    {
      lossy.push_back(SliceFileName(reader, slice));
    }
  }
  if (!lossy.empty())
  {
    warnings.push_back(std::to_string(lossy.size()) + " of " + std::to_string(SliceCount(reader)) +
      " images were compressed with loss, which may hide details: " + FileList(lossy) + ".");
  }
}

}
