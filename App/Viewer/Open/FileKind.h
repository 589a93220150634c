#ifndef Varimarch_Viewer_FileKind_h
#define Varimarch_Viewer_FileKind_h

#include <QString>

#include <optional>

namespace varimarch
{

/// Files that are opened in different ways.
enum class FileKind
{
  BareVoxels, ///< their form is asked for
  Scene,      ///< also sessions
  Volume,     ///< also what is missing or unknown, so that reading it tells the reason
};

/// @returns nothing if the file's disk does not answer for seconds
std::optional<FileKind> KindOfFile(const QString& path);

}

#endif
