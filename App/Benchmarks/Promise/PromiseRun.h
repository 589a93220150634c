#ifndef Varimarch_Promise_PromiseRun_h
#define Varimarch_Promise_PromiseRun_h

#include "PictureVerdict.h"
#include "PromiseKinds.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// One picture of a random scene, and how it was judged.
struct PromisePicture
{
  std::string kind;
  std::uint64_t seed; ///< seed of the scene
  int number;         ///< 0: the first picture of the scene; others come after edits
  int side;           ///< [pixels]
  double errorTolerance;
  bool saysKept; ///< GetErrorToleranceIsKept
  double estimatedError;
  std::string message; ///< the first error or warning that VTK has reported; empty: none
  PictureVerdict verdict;
  double drawSeconds;
  double judgeSeconds;

  bool IsSilentMiss() const
  {
    return this->saysKept && this->verdict.answer == PictureVerdict::Answer::Beyond;
  }
  bool IsFalseAlarm() const
  {
    return !this->saysKept && this->verdict.answer == PictureVerdict::Answer::Kept;
  }
};

/// The command that draws the scene of a picture alone.
std::string CommandFor(const PromisePicture& picture);

nlohmann::ordered_json ToJson(const PromisePicture& picture);

/// Draws a scene and all its edits, and judges each picture.
/// @param window  a window that was rendered to before keeps its shaders
/// @param onPicture  called after each picture
void DrawPromiseScene(const PromiseKind& kind, std::uint64_t seed, vtkOpenGLRenderWindow* window,
  const std::function<void(const PromisePicture&)>& onPicture);

/// The settings of `varimarch-bench promise`.
struct PromiseOptions
{
  int scenes = 200;
  std::uint64_t seed = 1;
  std::vector<std::string> only; ///< names of kinds; empty: all
  int side = 0; ///< largest height and width of pictures [pixels]; 0: those of the kind
};

/// Draws scenes of all kinds in turn. The first of each kind has the first seed, the next one the
/// next seed.
/// @throws std::invalid_argument for a kind that does not exist
void RunPromise(
  const PromiseOptions& options, const std::function<void(const PromisePicture&)>& onPicture);

}

#endif
