#include "Readers/Dicom/JoinedSeries.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace varimarch
{
namespace
{

bool IsSingleSlice(const DicomSeries& series)
{
  const DicomFrame& first = series.frames.front();
  return series.frames.size() == 1 && !first.file->isSegmentation && first.positionMm &&
    first.axes && first.pixelMm && !first.file->frameOfReference.empty();
}

bool MayBeOneVolume(const DicomSeries& a, const DicomSeries& b)
{
  constexpr double LargestDifference = 1e-3;
  const DicomFrame& first = a.frames.front();
  const DicomFrame& second = b.frames.front();
  return a.number == b.number && a.modality == b.modality && a.description == b.description &&
    first.file->frameOfReference == second.file->frameOfReference && first.size == second.size &&
    glm::distance(*first.pixelMm, *second.pixelMm) < LargestDifference &&
    glm::distance((*first.axes)[0], (*second.axes)[0]) < LargestDifference &&
    glm::distance((*first.axes)[1], (*second.axes)[1]) < LargestDifference;
}

bool LieAtOnePlace(const DicomSeries* a, const DicomSeries* b)
{
  constexpr double SamePlaceMm = 1e-3;
  return glm::distance(*a->frames.front().positionMm, *b->frames.front().positionMm) < SamePlaceMm;
}

/// True if no two series of a group lie at one place.
bool LieApart(const std::vector<DicomSeries*>& group)
{
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (LieAtOnePlace(group[i], group[j]))
      {
        return false;
      }
    }
  }
  return true;
}

}

void JoinSingleImages(std::vector<DicomSeries>& all, std::vector<std::string>& warnings)
{
  constexpr std::size_t LeastCount = 3; // fewer may be anything
  std::vector<std::vector<DicomSeries*>> groups;
  for (DicomSeries& series : all)
  {
    if (IsSingleSlice(series))
    {
      const auto known = std::find_if(groups.begin(), groups.end(),
        [&](const auto& group) { return MayBeOneVolume(*group.front(), series); });
      known == groups.end() ? groups.push_back({ &series }) : known->push_back(&series);
    }
  }
  for (const std::vector<DicomSeries*>& group : groups)
  {
    if (group.size() < LeastCount || !LieApart(group))
    {
      continue;
    }
    for (auto series = group.begin() + 1; series != group.end(); ++series)
    {
      group.front()->frames.push_back((*series)->frames.front());
      (*series)->frames.clear();
    }
    warnings.push_back(std::to_string(group.size()) +
      " series of one image each were joined, since they have the same number, size and direction "
      "and lie beside each other: " +
      FrameList(group.front()->frames) + ".");
  }
  all.erase(std::remove_if(all.begin(), all.end(),
              [](const DicomSeries& series) { return series.frames.empty(); }),
    all.end());
}

}
