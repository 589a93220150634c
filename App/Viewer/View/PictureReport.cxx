#include "Viewer/View/PictureReport.h"

#include "Viewer/Model/NumberText.h"

#include <QCoreApplication>

#include <vtkVariationFieldVolumeMapper.h>

#include <cmath>

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
  QString report = Texts::tr("%1\n%2\nerror unknown").arg(mapper, time);
  // Both need a mask.
  if (!CanCutByScissors(kind) && NeedMask(scene.cuts))
  {
    report += Texts::tr("\nmasks not supported");
  }
  if (!CanCutByScissors(kind) && scene.labels)
  {
    report += Texts::tr("\nsegments not supported");
  }
  return report;
}

}

PictureNumbers NumbersOf(vtkVariationFieldVolumeMapper* mapper)
{
  PictureNumbers numbers = { mapper->GetAccumulatedPictures(),
    mapper->GetMaximumAccumulatedPictures(), mapper->GetDrawnPart(), mapper->GetErrorTolerance(),
    mapper->GetErrorToleranceIsKept() };
  const int level = mapper->GetUsedLevelOfDetail();
  numbers.isCoarse = level == vtkVariationFieldVolumeMapper::CoarseLevel;
  if (level == vtkVariationFieldVolumeMapper::RefinedLevel && numbers.drawnPart < 1.0)
  {
    numbers.refinedError = mapper->GetLevelErrorBound();
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
  if (ours->averaged == 0)
  {
    const double part = ours->drawnPart * ours->mostAveraged;
    return Texts::tr("%1\n%2 % of the image").arg(time).arg(int(100.0 * part));
  }
  if (ours->isCoarse)
  {
    return Texts::tr("%1\ncoarse voxels, error unknown").arg(time);
  }
  if (ours->refinedError > 0.5 * ours->errorTolerance)
  {
    const double error = *ours->refinedError + 0.5 * ours->errorTolerance;
    return Texts::tr("%1\nerror at most %2 %, refining")
      .arg(time)
      .arg(NumberText(100.0 * error, 1));
  }
  if (ours->errorTolerance <= 0.0)
  {
    return Texts::tr("%1\nerror not bounded").arg(time);
  }
  QString report =
    Texts::tr("%1\nerror at most 1/%2").arg(time).arg(int(std::lround(1.0 / ours->errorTolerance)));
  if (!ours->keepsTolerance)
  {
    report += Texts::tr("\nexcept at single pixels");
  }
  if (ours->averaged > 1)
  {
    report += Texts::tr("\nmean of %1 frames").arg(ours->averaged);
  }
  return report;
}

}
