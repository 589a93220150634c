#include "PromiseRun.h"

#include "Readers/Parsing/VtkMessages.h"

#include <vtkHeadlessRenderWindow.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace varimarch
{

namespace
{

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

PromisePicture PictureOf(
  PromiseScene& scene, const PromiseKind& kind, std::uint64_t seed, int number)
{
  PromisePicture picture = {};
  picture.kind = kind.name;
  picture.seed = seed;
  picture.number = number;
  picture.side = scene.side;
  picture.errorTolerance = scene.Mapper()->GetErrorTolerance();
  const auto start = Clock::now();
  std::vector<float> drawn;
  {
    VtkMessages messages;
    messages.ObserveOutput();
    drawn = scene.Draw();
    picture.message = messages.FirstSentence();
  }
  picture.drawSeconds = SecondsSince(start);
  picture.saysKept = scene.Mapper()->GetErrorToleranceIsKept();
  picture.estimatedError = scene.Mapper()->GetEstimatedError();
  const auto judged = Clock::now();
  const JudgeScene truth = ReadJudgeScene(scene.Objects());
  picture.verdict = VerdictOn(truth, drawn, scene.DrawBehind(), seed);
  picture.judgeSeconds = SecondsSince(judged);
  return picture;
}

std::vector<PromiseKind> ChosenKinds(const std::vector<std::string>& only)
{
  if (only.empty())
  {
    return PromiseKinds();
  }
  std::vector<PromiseKind> chosen;
  for (const std::string& name : only)
  {
    const auto kind = std::find_if(PromiseKinds().begin(), PromiseKinds().end(),
      [&](const PromiseKind& one) { return one.name == name; });
    if (kind == PromiseKinds().end())
    {
      throw std::invalid_argument("There is no kind of random scenes named \"" + name + "\"");
    }
    chosen.push_back(*kind);
  }
  return chosen;
}

// The seed of the dice, so that kinds do not choose alike. The hash is FNV-1a.
std::uint64_t DiceSeed(const PromiseKind& kind, std::uint64_t seed)
{
  std::uint64_t hash = 14695981039346656037u;
  for (const char letter : kind.name)
  {
    hash = (hash ^ std::uint64_t(static_cast<unsigned char>(letter))) * 1099511628211u;
  }
  return hash + seed;
}

void DrawSized(const PromiseKind& kind, std::uint64_t seed, int side, vtkOpenGLRenderWindow* window,
  const std::function<void(const PromisePicture&)>& onPicture)
{
  PromiseScene scene(DiceSeed(kind, seed), window);
  kind.make(scene);
  scene.side = side > 0 ? std::min(scene.side, side) : scene.side;
  onPicture(PictureOf(scene, kind, seed, 0));
  for (std::size_t i = 0; i < scene.edits.size(); ++i)
  {
    scene.edits[i]();
    onPicture(PictureOf(scene, kind, seed, int(i) + 1));
  }
}

std::string NameOf(PictureVerdict::Answer answer)
{
  using Answer = PictureVerdict::Answer;
  return answer == Answer::Kept ? "kept" : (answer == Answer::Beyond ? "beyond" : "unsettled");
}

}

std::string CommandFor(const PromisePicture& picture)
{
  return "varimarch-bench promise --only " + picture.kind + " --seed " +
    std::to_string(picture.seed) + " --scenes 1";
}

nlohmann::ordered_json ToJson(const PromisePicture& picture)
{
  const PictureVerdict& verdict = picture.verdict;
  return { { "kind", picture.kind }, { "seed", picture.seed }, { "picture", picture.number },
    { "side", picture.side }, { "errorTolerance", picture.errorTolerance },
    { "saysKept", picture.saysKept }, { "estimatedError", picture.estimatedError },
    { "answer", NameOf(verdict.answer) }, { "factor", verdict.factor },
    { "largest", verdict.largest }, { "worst", { verdict.worstX, verdict.worstY } },
    { "beyond", verdict.beyond }, { "doubtful", verdict.doubtful }, { "pixels", verdict.pixels },
    { "message", picture.message }, { "drawSeconds", picture.drawSeconds },
    { "judgeSeconds", picture.judgeSeconds }, { "alone", CommandFor(picture) } };
}

void DrawPromiseScene(const PromiseKind& kind, std::uint64_t seed, vtkOpenGLRenderWindow* window,
  const std::function<void(const PromisePicture&)>& onPicture)
{
  DrawSized(kind, seed, 0, window, onPicture);
}

void RunPromise(
  const PromiseOptions& options, const std::function<void(const PromisePicture&)>& onPicture)
{
  const std::vector<PromiseKind> kinds = ChosenKinds(options.only);
  vtkNew<vtkHeadlessRenderWindow> window;
  for (int i = 0; i < options.scenes; ++i)
  {
    DrawSized(kinds[std::size_t(i) % kinds.size()], options.seed + std::uint64_t(i) / kinds.size(),
      options.side, window, onPicture);
  }
}

}
