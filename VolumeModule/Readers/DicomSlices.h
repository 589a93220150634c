#ifndef Varimarch_Readers_DicomSlices_h
#define Varimarch_Readers_DicomSlices_h

#include <vtkDICOMTag.h>

#include <string>
#include <vector>

class vtkDICOMReader;
class vtkDICOMValue;

namespace varimarch
{

// What a reader that has put its slices in order says about each, and what is doubtful about them.

int SliceCount(vtkDICOMReader* reader);

/// Attribute of the file and frame that a slice came from.
const vtkDICOMValue& SliceValue(vtkDICOMReader* reader, int slice, vtkDICOMTag tag);

/// The name of a file, without the folder.
std::string FileName(const std::string& path);
std::string SliceFileName(vtkDICOMReader* reader, int slice);

/// Names as words of a sentence: "a.dcm", "b.dcm" and 7 others.
std::string FileList(const std::vector<std::string>& names);

/// Leaves the reader with the files whose slices lie as most do; others, such as a scout of the
/// same size, are no slices of the same volume.
void KeepOneDirection(vtkDICOMReader* reader, std::vector<std::string>& warnings);

/// Compression that has changed the values.
void WarnOfLoss(vtkDICOMReader* reader, std::vector<std::string>& warnings);

}

#endif
