#ifndef Varimarch_Readers_Dicom_Values_h
#define Varimarch_Readers_Dicom_Values_h

#include "Readers/Dicom/DicomFrame.h"
#include "Readers/Rescale.h"
#include "Readers/VoxelLayout.h"

#include <optional>

class vtkImageData;

namespace varimarch
{

/// The layout of a volume of stored values: the type that holds those of all frames, with colours
/// in place of numbers of colours, and entries of modality tables in place of their indices.
/// @param frames  slices of one size
VoxelLayout StoredLayout(const std::vector<DicomFrame>& frames);

/// Copies the values of a frame to a slice of a volume of StoredLayout.
/// @param decoded  all frames of the frame's file
void PutSlice(const DicomFrame& frame, vtkImageData* decoded, vtkImageData* stored, int slice);

/// The maps from the stored values of each slice to physical ones.
std::vector<Rescale> RescalesOf(const std::vector<DicomFrame>& frames);

/// Sets voxels that the files mark as padding and that are brighter than the whole image to the
/// lowest value of the image.
/// @param image  rescaled values of the frames
/// @param warnings  receives a sentence if there are such voxels
/// @return the lowest value of the image if there is padding below it
std::optional<double> SetPaddingToLowest(
  const std::vector<DicomFrame>& frames, vtkImageData* image, std::vector<std::string>& warnings);

}

#endif
