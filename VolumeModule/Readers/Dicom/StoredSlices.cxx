#include "Readers/Dicom/StoredSlices.h"

#include "Readers/Decoder/DicomDecoding.h"
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

StoredSlices DecodedSlices(
  const std::string& path, const DicomSlices& slices, ReadProgress& progress)
{
  StoredSlices stored = { slices, nullptr, {} };
  const VoxelLayout layout = StoredLayout(slices.frames);
  CheckedByteCount(path, layout);
  stored.image = AllocatedImage(layout);
  const std::vector<std::vector<int>> files = SlicesOfFiles(slices.frames);
  std::vector<bool> isDecoded(slices.frames.size(), false);
  std::vector<const DicomFile*> toDecode;
  for (const std::vector<int>& slicesOfFile : files)
  {
    toDecode.push_back(slices.frames[std::size_t(slicesOfFile.front())].file.get());
    CheckFrames(path, *toDecode.back());
  }
  ForEachDecoded(
    toDecode,
    [&](std::size_t i, const DecodedPixels& pixels)
    {
      if (pixels.fault)
      {
        stored.faults.push_back(*pixels.fault);
      }
      for (const int slice : pixels.fault ? std::vector<int>() : files[i])
      {
        PutSlice(slices.frames[std::size_t(slice)], pixels.image, stored.image, slice);
        isDecoded[std::size_t(slice)] = true;
      }
    },
    progress);
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
