#ifndef Varimarch_Readers_Images_TiffFile_h
#define Varimarch_Readers_Images_TiffFile_h

#include "Readers/VoxelLayout.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

struct tiff;

namespace varimarch
{

/// A page (image file directory) of a TIFF file.
struct TiffPage
{
  VoxelLayout layout;        ///< one slice
  bool isReduced;            ///< true for a thumbnail of another page
  bool isInverted;           ///< true if the largest value is black
  bool holdsColors;          ///< true if the values of a pixel are its colour
  int orientation;           ///< the tag Orientation, 1 to 8
  std::uint64_t directory;   ///< file offset of the page's directory
  std::uint64_t slice;       ///< the number of the page among those that its directory describes
  std::optional<int> sample; ///< the plane of components that is the page, see SplitSamples
  std::array<double, 2> pixelsPerUnit; ///< the tags XResolution and YResolution; 0 if missing
  double mmPerUnit; ///< length of the tag ResolutionUnit [mm]; 0 if it states no length
};

/// The distances of pixels by the resolution of a page [mm]; 0 if it states none.
std::array<double, 2> PixelSpacingMm(const TiffPage& page);

/// The pages of a TIFF or BigTIFF file. libtiff decodes them; its messages are collected. A
/// directory with the tag ImageDepth describes as many pages.
class TiffFile
{
public:
  /// Reads the directories of all pages.
  /// @throws std::runtime_error for damaged directories, or types that are not supported
  explicit TiffFile(const std::string& path);
  ~TiffFile();
  TiffFile(const TiffFile&) = delete;
  void operator=(const TiffFile&) = delete;

  const std::string& Path() const { return this->path; }
  const std::vector<TiffPage>& Pages() const { return this->pages; }

  /// The tag ImageDescription of the first page, or empty.
  const std::string& Description() const { return this->description; }

  /// Adds pages without directories, whose uncompressed pixels follow those of the first page.
  /// ImageJ stores volumes beyond 4 GB like this, and MetaMorph all stacks.
  void AddPagesBehindFirst(std::size_t count);

  /// Takes the components of all pages that have them in planes of their own for pages.
  void SplitSamples();

  /// Fails unless the file is long enough for the pixels of a page.
  void CheckHoldsPage(std::size_t page);

  /// Decodes the pixels of a page, whose memory must have the size of its layout.
  void ReadPage(std::size_t page, void* destination);

private:
  struct Messages;
  struct PixelRows;

  void SelectPage(std::size_t page);
  TiffPage CurrentPage();
  /// Appends the pages that the current directory describes.
  void AddCurrentPages();
  /// Fails for a directory that is cut off. libtiff takes it for the last one.
  void CheckHoldsDirectory(std::uint64_t offset);
  void ReadAsColours(const TiffPage& page, void* destination);
  void ReadBehindFirst(std::size_t page, void* destination);
  void ReadStrips(const PixelRows& rows, std::uint16_t plane);
  void ReadTiles(const PixelRows& rows, std::uint16_t plane, std::uint64_t slice);
  /// Reads one of the slices of a tile.
  bool ReadTile(const std::array<std::uint32_t, 3>& place, std::uint16_t plane, int valueBytes,
    std::vector<char>& slice);
  [[noreturn]] void Fail(const std::string& expected);

  std::string path;
  std::unique_ptr<Messages> messages;
  tiff* file = nullptr;
  std::string description;
  std::vector<TiffPage> pages;
};

}

#endif
