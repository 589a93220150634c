#include "PromiseReport.h"

#include "CommandLine/Results.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace varimarch
{

namespace
{

using Answer = PictureVerdict::Answer;

std::string NameOf(Answer answer)
{
  return answer == Answer::Kept ? "kept" : (answer == Answer::Beyond ? "beyond" : "unsettled");
}

std::string FixedOrInfinite(double number, int digits)
{
  return std::isfinite(number) ? Fixed(number, digits) : "inf";
}

std::string RowOf(const std::string& name, const PromiseCounts& counts)
{
  std::ostringstream row;
  row << "| " << name << " | " << counts.pictures << " | " << counts.kept << " | "
      << counts.silentMisses << " | " << counts.falseAlarms << " | " << counts.unsettled << " | "
      << counts.messages << " | " << FixedOrInfinite(counts.worstFactor, 2) << " | "
      << Fixed(counts.drawSeconds, 1) << " | " << Fixed(counts.judgeSeconds, 1) << " |\n";
  return row.str();
}

std::string LineOf(const PromisePicture& picture)
{
  const PictureVerdict& verdict = picture.verdict;
  std::ostringstream line;
  line << "- " << picture.kind << ", picture " << picture.number << " of seed " << picture.seed
       << ": " << NameOf(verdict.answer) << ", 99.9 % off by up to "
       << FixedOrInfinite(verdict.factor, 2) << " x, largest "
       << FixedOrInfinite(verdict.largest, 2) << " x at pixel " << verdict.worstX << ", "
       << verdict.worstY << ", " << verdict.beyond << " of " << verdict.pixels
       << " pixels beyond for certain, " << verdict.doubtful << " doubtful; tolerance "
       << picture.errorTolerance << ", estimated " << picture.estimatedError << ", kept "
       << int(picture.saysKept) << ": `" << CommandFor(picture) << "`"
       << (picture.message.empty() ? "" : "; " + picture.message) << "\n";
  return line.str();
}

template <class Is>
void ListThose(std::ostringstream& text, const std::vector<PromisePicture>& pictures,
  const std::string& title, Is is)
{
  bool isFirst = true;
  for (const PromisePicture& picture : pictures)
  {
    if (is(picture))
    {
      text << (isFirst ? "\n" + title + "\n\n" : "") << LineOf(picture);
      isFirst = false;
    }
  }
}

}

void PromiseCounts::Add(const PromisePicture& picture)
{
  ++this->pictures;
  this->kept += picture.verdict.answer == Answer::Kept;
  this->silentMisses += picture.IsSilentMiss();
  this->falseAlarms += picture.IsFalseAlarm();
  this->unsettled += picture.verdict.answer == Answer::Unsettled;
  this->messages += !picture.message.empty();
  this->worstFactor =
    picture.saysKept ? std::max(this->worstFactor, picture.verdict.factor) : this->worstFactor;
  this->drawSeconds += picture.drawSeconds;
  this->judgeSeconds += picture.judgeSeconds;
}

std::string CommandFor(const PromisePicture& picture)
{
  return "varimarch-bench promise --only " + picture.kind + " --seed " +
    std::to_string(picture.seed) + " --scenes 1";
}

std::string PromiseMarkdown(const std::vector<PromisePicture>& pictures)
{
  std::ostringstream text;
  text
    << "| kind | pictures | kept | silent misses | false alarms | unsettled | messages | worst "
       "factor | drawing [s] | judging [s] |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  PromiseCounts all;
  PromiseCounts lit;
  for (const PromiseKind& kind : PromiseKinds())
  {
    PromiseCounts counts;
    for (const PromisePicture& picture : pictures)
    {
      if (picture.kind == kind.name)
      {
        counts.Add(picture);
        all.Add(picture);
        if (kind.isLit)
        {
          lit.Add(picture);
        }
      }
    }
    text << (counts.pictures > 0 ? RowOf(kind.name, counts) : "");
  }
  text << RowOf("with light", lit) << RowOf("all", all);
  ListThose(text, pictures,
    "Silent misses:", [](const PromisePicture& picture) { return picture.IsSilentMiss(); });
  ListThose(text, pictures,
    "False alarms:", [](const PromisePicture& picture) { return picture.IsFalseAlarm(); });
  ListThose(text, pictures, "Unsettled:",
    [](const PromisePicture& picture) { return picture.verdict.answer == Answer::Unsettled; });
  ListThose(text, pictures, "Beyond the tolerance, and said so:",
    [](const PromisePicture& picture)
    { return !picture.saysKept && picture.verdict.answer == Answer::Beyond; });
  return text.str();
}

nlohmann::ordered_json PromiseJson(const std::vector<PromisePicture>& pictures)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const PromisePicture& picture : pictures)
  {
    list.push_back(
      { { "kind", picture.kind }, { "seed", picture.seed }, { "picture", picture.number },
        { "side", picture.side }, { "errorTolerance", picture.errorTolerance },
        { "saysKept", picture.saysKept }, { "estimatedError", picture.estimatedError },
        { "answer", NameOf(picture.verdict.answer) }, { "factor", picture.verdict.factor },
        { "largest", picture.verdict.largest }, { "beyond", picture.verdict.beyond },
        { "doubtful", picture.verdict.doubtful }, { "message", picture.message },
        { "drawSeconds", picture.drawSeconds }, { "judgeSeconds", picture.judgeSeconds } });
  }
  return list;
}

}
