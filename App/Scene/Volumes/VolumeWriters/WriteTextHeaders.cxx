// NRRD and MetaImage: a text header, and the values behind it. See
// http://teem.sourceforge.net/nrrd/format.html and https://itk.org/Wiki/ITK/MetaIO/Documentation
#include "Scene/Volumes/VolumeWriters/VolumeWriters.h"
#include "Scene/Volumes/VolumeWriters/WrittenImage.h"

#include <algorithm>
#include <sstream>

namespace varimarch
{

namespace
{

std::string SizeText(const std::array<int, 3>& size)
{
  return std::to_string(size[0]) + ' ' + std::to_string(size[1]) + ' ' + std::to_string(size[2]);
}

/// A vector in NRRD's form, "(x,y,z)".
std::string NrrdVector(const glm::dvec3& vector)
{
  return '(' + TextOf(vector, ',') + ')';
}

/// NRRD's name for an axis with the components of a voxel.
std::string NrrdKind(int componentCount)
{
  return componentCount == 3 ? "RGB-color" : componentCount == 4 ? "RGBA-color" : "vector";
}

/// Names cannot hold the ends of lines.
std::string OneLine(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// The keys by which 3D Slicer knows segments in a file of its own, ".seg.nrrd".
std::string SegmentKeys(const std::vector<Segment>& segments, const std::array<int, 3>& size)
{
  std::string keys;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const std::string key = "Segment" + std::to_string(i) + '_';
    keys += key + "ID:=Segment_" + std::to_string(i + 1) + '\n' + key +
      "Name:=" + OneLine(segments[i].name) + '\n' + key + "Color:=" + TextOf(segments[i].rgb) +
      '\n' + key + "LabelValue:=" + std::to_string(segments[i].value) + '\n' + key + "Layer:=0\n" +
      key + "Extent:=0 " + std::to_string(size[0] - 1) + " 0 " + std::to_string(size[1] - 1) +
      " 0 " + std::to_string(size[2] - 1) + '\n';
  }
  return keys +
    (segments.empty() ? ""
                      : "Segmentation_MasterRepresentation:=Binary labelmap\n"
                        "Segmentation_ContainedRepresentationNames:=Binary labelmap|\n"
                        "Segmentation_ReferenceImageExtentOffset:=0 0 0\n");
}

// Characters that make a header's length a multiple of eight: voxels that begin there can be used
// where they are in the file.
std::string FillingUp(std::size_t length)
{
  constexpr std::size_t Multiple = 8;
  return std::string((Multiple - length % Multiple) % Multiple, '.');
}

}

bool WriteNrrdFile(const LoadedVolume& volume, const std::string& path, bool)
{
  const WrittenImage image(path, volume.image);
  const int componentCount = image.ComponentCount();
  const bool hasComponents = componentCount > 1;
  std::string directions;
  for (int axis = 0; axis < 3; ++axis)
  {
    directions += ' ' + NrrdVector(image.Direction()[axis] * image.SpacingMm()[axis]);
  }
  std::string header = std::string("NRRD0004\ntype: ") + image.Type().nrrd +
    "\ndimension: " + (hasComponents ? "4" : "3") + "\nspace: left-posterior-superior\nsizes: " +
    (hasComponents ? std::to_string(componentCount) + ' ' : "") + SizeText(image.Size()) +
    "\nspace directions:" + (hasComponents ? " none" : "") + directions +
    "\nkinds: " + (hasComponents ? NrrdKind(componentCount) + ' ' : "") +
    "domain domain domain\nendian: " + (IsBigEndianMachine() ? "big" : "little") +
    "\nencoding: raw\nspace origin: " + NrrdVector(image.OriginMm()) + '\n' +
    SegmentKeys(volume.segments, image.Size());
  const std::string comment = "# ";
  const std::string end = "\n\n";
  header += comment + FillingUp(header.size() + comment.size() + end.size()) + end;
  return WriteHeaderAndValues(path, header, image);
}

bool WriteMetaImageFile(const LoadedVolume& volume, const std::string& path, bool)
{
  const WrittenImage image(path, volume.image);
  const glm::dmat3 direction = image.Direction();
  const int componentCount = image.ComponentCount();
  const bool isKnown = volume.modality == "CT" || volume.modality == "MR";
  std::ostringstream text;
  text << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = "
       << (IsBigEndianMachine() ? "True" : "False")
       << "\nCompressedData = False\nTransformMatrix = " << TextOf(direction[0]) << ' '
       << TextOf(direction[1]) << ' ' << TextOf(direction[2])
       << "\nOffset = " << TextOf(image.OriginMm())
       << "\nCenterOfRotation = 0 0 0\nElementSpacing = " << TextOf(image.SpacingMm())
       << "\nDimSize = " << SizeText(image.Size())
       << (isKnown ? "\nModality = MET_MOD_" + volume.modality : "")
       << (componentCount > 1 ? "\nElementNumberOfChannels = " + std::to_string(componentCount)
                              : "")
       << "\nElementType = " << image.Type().metaImage << "\nComment = .";
  const std::string end = "\nElementDataFile = LOCAL\n";
  const std::string header = text.str();
  return WriteHeaderAndValues(path, header + FillingUp(header.size() + end.size()) + end, image);
}

}
