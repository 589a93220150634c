#ifndef Varimarch_Readers_Dicom_Mosaic_h
#define Varimarch_Readers_Dicom_Mosaic_h

#include "Readers/Dicom/DicomFrame.h"

class vtkDICOMMetaData;

namespace varimarch
{

/// True for a picture of Siemens MR scanners whose tiles are the slices of a volume.
bool IsMosaic(vtkDICOMMetaData* meta);

/// The slices of a mosaic, as tiles of its frames; none if the file does not say how many tiles
/// there are and in which direction they follow each other.
///
/// The position that the file states is that of the first pixel of an image of the mosaic's size
/// around the centre of the first tile (nibabel, "Siemens mosaic format").
std::vector<DicomFrame> MosaicTiles(vtkDICOMMetaData* meta, const std::vector<DicomFrame>& frames);

}

#endif
