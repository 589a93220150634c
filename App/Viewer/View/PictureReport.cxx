#include "Viewer/View/PictureReport.h"

#include "Scene/Model/SceneLights.h"
#include "Viewer/Model/MeasureTexts.h"

#include <QCoreApplication>

#include <vtkVariationFieldVolumeMapper.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace varimarch
{

namespace
{

struct Texts
{
  Q_DECLARE_TR_FUNCTIONS(PictureReport)
};

QString ReportOfVtk(MapperKind kind, const Scene& scene, const QString& time)
{
  const QString mapper = kind == MapperKind::VtkGpu ? Texts::tr("VTK, GPU") : Texts::tr("VTK, CPU");
  QStringList lines = { Texts::tr("%1\n%2\nerror unknown").arg(mapper, time) };
  lines += LeftOutByVtk(kind, scene);
  return lines.join('\n');
}

QString PartOf(const PictureNumbers& ours)
{
  const double part = ours.averaged == 0 ? ours.drawnPart * ours.mostAveraged : 0.0;
  return Texts::tr("refining, %1 %").arg(int(100.0 * part));
}

// The sentence in lines that fit into the corner of a small view; empty without a reason.
QString NoticeOfNothing(const std::string& reason)
{
  constexpr int LongestLine = 44;
  if (reason.empty())
  {
    return {};
  }
  QString notice;
  int length = 0;
  for (const QString& word :
    Texts::tr("Nothing is visible: %1.").arg(QString::fromStdString(reason)).split(' '))
  {
    const bool fits = length > 0 && length + word.size() < LongestLine;
    notice += (fits ? ' ' : '\n') + word;
    length = int(word.size()) + (fits ? length + 1 : 0);
  }
  return notice;
}

QString BoundedError(const PictureNumbers& ours)
{
  if (!ours.keepsTolerance && ours.estimatedError > ours.errorTolerance)
  {
    return Texts::tr("error about %1 %").arg(NumberText(100.0 * ours.estimatedError, 1));
  }
  const int parts = int(std::lround(1.0 / ours.errorTolerance));
  QString error = ours.isRefined ? Texts::tr("error at most 1/%1, refined").arg(parts)
                                 : Texts::tr("error at most 1/%1").arg(parts);
  if (!ours.keepsTolerance)
  {
    error += Texts::tr("\nexcept at single pixels");
  }
  if (ours.averaged > 1)
  {
    error += Texts::tr("\nmean of %1 frames").arg(ours.averaged);
  }
  return error;
}

QString Remedy(const PictureNumbers& ours)
{
  return ours.voxelsFit ? QString()
                        : Texts::tr("\nLess error takes long, since its voxels do not fit in the "
                                    "memory:\nallow more in the menu File, or zoom in.");
}

// A bound of the error is told only if it holds for the pixels that are shown.
QString ErrorOf(const PictureNumbers& ours)
{
  const bool isWhole = ours.averaged > 0 && ours.isFine;
  if (ours.isMoving && (ours.isOutOfDate || !isWhole))
  {
    return Texts::tr("moving");
  }
  if (ours.isOutOfDate)
  {
    return Texts::tr("out of date");
  }
  if (!isWhole)
  {
    return PartOf(ours) + Remedy(ours);
  }
  if (ours.isCoarse)
  {
    return Texts::tr("coarse voxels, error unknown");
  }
  if (ours.refinedError > 0.5 * ours.errorTolerance)
  {
    const double error = std::min(*ours.refinedError + 0.5 * ours.errorTolerance, 1.0);
    return Texts::tr("error at most %1 %, refining").arg(NumberText(100.0 * error, 1)) +
      Remedy(ours);
  }
  return ours.errorTolerance > 0.0 ? BoundedError(ours) : Texts::tr("error not bounded");
}

}

QStringList LeftOutByVtk(MapperKind kind, const Scene& scene)
{
  const bool isMasking = CanCutByScissors(kind);
  const bool hasOverlays = std::any_of(scene.overlays.begin(), scene.overlays.end(),
    [](const OverlaidVolume& overlay) { return overlay.visible; });
  const Lighting light = LightingOf(scene);
  const std::pair<bool, QString> parts[] = {
    { !isMasking && NeedMask(scene.cuts), Texts::tr("masks not supported") },
    { !isMasking && scene.labels.has_value(), Texts::tr("segments not supported") },
    { !isMasking && !scene.look.regions.empty(), Texts::tr("regions not supported") },
    { !CanBlend(kind, scene.look.blend), Texts::tr("blend mode not supported") },
    { !CanOverlay(kind) && hasOverlays, Texts::tr("further scans not supported") },
    { light.shadows > 0.0 || light.scattering.blending > 0.0 || light.occlusion.strength > 0.0,
      Texts::tr("shadows not supported") },
    { scene.render.interpolation == Interpolation::Cubic,
      Texts::tr("cubic interpolation not supported") },
  };
  QStringList leftOut;
  for (const auto& [isLeftOut, text] : parts)
  {
    if (isLeftOut)
    {
      leftOut << text;
    }
  }
  return leftOut;
}

PictureNumbers NumbersOf(vtkVariationFieldVolumeMapper* mapper)
{
  constexpr double MostPixelsPerRay = 1.001; // the numbers of rays are rounded
  PictureNumbers numbers = { mapper->GetAccumulatedPictures(),
    mapper->GetMaximumAccumulatedPictures(), mapper->GetDrawnPart(), mapper->GetErrorTolerance(),
    mapper->GetErrorToleranceIsKept(), mapper->GetEstimatedError() };
  const int level = mapper->GetUsedLevelOfDetail();
  numbers.isCoarse = level == vtkVariationFieldVolumeMapper::CoarseLevel;
  numbers.isFine = mapper->GetUsedImageSampleDistance() <= MostPixelsPerRay;
  if (level == vtkVariationFieldVolumeMapper::RefinedLevel)
  {
    const double bound = mapper->GetLevelErrorBound();
    numbers.isRefined = bound <= 0.5 * numbers.errorTolerance;
    if (numbers.drawnPart < 1.0)
    {
      numbers.refinedError = bound;
      numbers.voxelsFit = mapper->GetNextRefinementFits();
    }
  }
  return numbers;
}

QString PictureReport(
  const std::optional<PictureNumbers>& ours, MapperKind kind, const Scene& scene, double seconds)
{
  const QString time = Texts::tr("%1 ms").arg(NumberText(1e3 * seconds, 0));
  if (!ours)
  {
    return ReportOfVtk(kind, scene, time);
  }
  if (ours->averaged == 0 && ours->drawnPart == 0.0)
  {
    return ErrorOf(*ours); // there is no image yet
  }
  const QString notice = ours->isOutOfDate ? QString() : NoticeOfNothing(ours->reasonForNothing);
  return time + '\n' + ErrorOf(*ours) + notice;
}

}
