#include "Readers/Dicom/StoredSlices.h"

#include "Readers/Dicom/Pixels.h"
#include "Readers/Dicom/Values.h"
#include "Readers/FileError.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace varimarch
{
namespace
{

/// Indices of the slices of each file, in the order of the files' first slices.
std::vector<std::vector<int>> SlicesOfFiles(const std::vector<DicomFrame>& frames)
{
  std::vector<std::vector<int>> all;
  std::map<const DicomFile*, std::size_t> indices;
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    const std::size_t file = indices.insert({ frames[i].file.get(), all.size() }).first->second;
    all.resize(indices.size());
    all[file].push_back(int(i));
  }
  return all;
}

/// Keeps the slices that were decoded.
void LeaveOutMissing(const std::vector<bool>& isDecoded, StoredSlices& stored)
{
  vtkImageData* const all = stored.image;
  const DicomSlices slices = stored.slices;
  const int* const dimensions = all->GetDimensions();
  const auto count = std::count(isDecoded.begin(), isDecoded.end(), true);
  auto image = AllocatedImage({ { dimensions[0], dimensions[1], count }, all->GetScalarType(),
    all->GetNumberOfScalarComponents() });
  const std::size_t sliceBytes = std::size_t(dimensions[0]) * std::size_t(dimensions[1]) *
    std::size_t(all->GetNumberOfScalarComponents() * all->GetScalarSize());
  stored.slices.frames.clear();
  stored.slices.heightsMm.clear();
  for (std::size_t i = 0; i < isDecoded.size(); ++i)
  {
    if (isDecoded[i])
    {
      std::memcpy(image->GetScalarPointer(0, 0, int(stored.slices.frames.size())),
        all->GetScalarPointer(0, 0, int(i)), sliceBytes);
      stored.slices.frames.push_back(slices.frames[i]);
      stored.slices.heightsMm.push_back(slices.heightsMm[i]);
    }
  }
  stored.image = image;
}

}

void CheckFrames(const std::string& path, const DicomFile& file)
{
  const int type = file.bitsAllocated <= 8 ? VTK_UNSIGNED_CHAR
    : file.bitsAllocated <= 16             ? VTK_SHORT
                                           : VTK_DOUBLE;
  CheckedByteCount(path, { { file.columns, file.rows, file.frameCount }, type, file.samples });
}

StoredSlices DecodedSlices(
  const std::string& path, const DicomSlices& slices, ReadProgress& progress)
{
  StoredSlices stored = { slices, nullptr, {} };
  const VoxelLayout layout = StoredLayout(slices.frames);
  CheckedByteCount(path, layout);
  stored.image = AllocatedImage(layout);
  const std::vector<std::vector<int>> files = SlicesOfFiles(slices.frames);
  std::vector<bool> isDecoded(slices.frames.size(), false);
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const DicomFile& file = *slices.frames[std::size_t(files[i].front())].file;
    CheckFrames(path, file);
    const DecodedPixels pixels = DecodePixels(file);
    if (pixels.fault)
    {
      stored.faults.push_back(*pixels.fault);
    }
    for (const int slice : pixels.fault ? std::vector<int>() : files[i])
    {
      PutSlice(slices.frames[std::size_t(slice)], pixels.image, stored.image, slice);
      isDecoded[std::size_t(slice)] = true;
    }
    progress.Report(double(i + 1) / double(files.size()));
  }
  if (stored.faults.size() == files.size())
  {
    const DicomFault& fault = stored.faults.front();
    FailToRead(fault.path, fault.expected, fault.found);
  }
  if (!stored.faults.empty())
  {
    LeaveOutMissing(isDecoded, stored);
  }
  return stored;
}

}
