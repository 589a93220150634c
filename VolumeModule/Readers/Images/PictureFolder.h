#ifndef Varimarch_Readers_Images_PictureFolder_h
#define Varimarch_Readers_Images_PictureFolder_h

#include <string>
#include <vector>

namespace varimarch
{

/// The pictures of a folder that are slices, and what the folder says about them.
struct PictureFolder
{
  std::vector<std::string> slices; ///< paths, from the first slice to the last
  std::string preview;             ///< the name of a picture that shows the scan; or empty
  double voxelMm = 0.0;            ///< side of a cubic voxel; 0 if unknown
};

/// Finds the pictures of a folder. Numbers in names are in order of their values, negative ones
/// too. Beside the slices of a SkyScan reconstruction lie a preview, "NAME_spr", and a log with the
/// size of a voxel.
PictureFolder PictureFolderAt(const std::string& folder);

}

#endif
