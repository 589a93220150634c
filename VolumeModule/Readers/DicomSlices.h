#ifndef Varimarch_Readers_DicomSlices_h
#define Varimarch_Readers_DicomSlices_h

#include <vtkDICOMTag.h>

#include <string>
#include <vector>

class vtkDICOMReader;
class vtkDICOMValue;

namespace varimarch
{

// Queries about the slices of a reader that has already sorted them.

int SliceCount(vtkDICOMReader* reader);

/// An attribute of the file and frame that a slice comes from.
const vtkDICOMValue& SliceValue(vtkDICOMReader* reader, int slice, vtkDICOMTag tag);

/// The name of a file without its folder.
std::string FileName(const std::string& path);
std::string SliceFileName(vtkDICOMReader* reader, int slice);

/// The names as part of a sentence: "a.dcm", "b.dcm" and 7 others.
std::string FileList(const std::vector<std::string>& names);

/// Restricts the reader to the files with the most frequent slice direction. Others, such as a
/// scout view of the same size, are not slices of the same volume.
void KeepOneDirection(vtkDICOMReader* reader, std::vector<std::string>& warnings);

/// Warns of images that lossy compression has changed.
void WarnOfLoss(vtkDICOMReader* reader, std::vector<std::string>& warnings);

}

#endif
