#include "Viewer/Open/FileKind.h"

#include "Scene/RawGuess.h"
#include "Scene/SceneFile.h"
#include "Viewer/Model/BackgroundTask.h"

#include <filesystem>
#include <string>

namespace varimarch
{

std::optional<FileKind> KindOfFile(const QString& path)
{
  return ResultInTime(
    [path = path.toStdString()]
    {
      std::error_code ignored;
      if (IsBareVoxels(path) && std::filesystem::exists(path, ignored))
      {
        return FileKind::BareVoxels;
      }
      return IsSceneFile(path) ? FileKind::Scene : FileKind::Volume;
    });
}

}
