#ifndef Varimarch_Readers_SegmentFrames_h
#define Varimarch_Readers_SegmentFrames_h

#include "Readers/Dicom/FileHeader.h"
#include "Readers/Dicom/GdcmCopy.h"
#include "Readers/VolumeFile.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <fstream>
#include <vector>

namespace varimarch
{

enum class SegmentationKind
{
  Binary,     ///< 1 where the segment of the frame is
  Fractional, ///< the part of the voxel that is in the segment, or its probability
  Labels      ///< the number of the segment
};

/// The kind that a segmentation says it is; binary if it does not say.
SegmentationKind SegmentationKindOf(vtkDICOMMetaData* meta);

/// The segments that a segmentation describes.
std::vector<LabelledSegment> DescribedSegments(vtkDICOMMetaData* meta);

/// The pixels of a segmentation frame by frame, as numbers of segments. Masks of single bits are
/// unpacked as they are needed: those of all segments would need far more memory than the labels.
class SegmentFrames
{
public:
  /// @param header  the header of a file with pixels; must outlive this object
  /// @throws std::runtime_error if the pixels cannot be decoded
  explicit SegmentFrames(const DicomHeader& header);

  /// The numbers of the segments of a frame's pixels, row by row; 0 for none.
  /// @throws std::runtime_error if the file cannot be read
  std::vector<std::uint16_t> NumbersOf(const DicomFrame& frame);

private:
  std::vector<std::uint16_t> Unpacked(const DicomFrame& frame);
  std::vector<std::uint16_t> Decoded(const DicomFrame& frame) const;

  const DicomHeader& header;
  const DicomFile& file;
  std::shared_ptr<const ScratchFile> inflated; ///< a copy of the file, if it is deflated
  SegmentationKind kind;
  double least = 1.0;                    ///< smallest stored value inside a segment
  std::ifstream bits;                    ///< the file, if its pixels are single bits
  vtkSmartPointer<vtkImageData> decoded; ///< all frames, if its pixels are larger
};

/// Number of the segment of a frame; 0 if it does not say.
int SegmentNumberOf(const DicomFrame& frame);

}

#endif
