#include "Viewer/Model/MeasureTexts.h"

#include "Scene/Measures.h"
#include "Scene/Placing.h"
#include "Scene/ScenePicking.h"
#include "Scene/VolumeLoading.h"
#include "Viewer/Model/NumberText.h"
#include "Viewer/Model/Study.h"

#include <vtkImageData.h>

namespace varimarch
{

namespace
{

constexpr double Mm3PerMl = 1000.0;

QString FourDigits(double value)
{
  return QLocale().toString(value, 'g', 4);
}

QString MeanText(const RegionStatistics& statistics, const QString& unit)
{
  return MeasureTexts::tr("mean %1 ± %2%3")
    .arg(FourDigits(statistics.mean), FourDigits(statistics.standardDeviation), unit);
}

QString BoxText(const RegionStatistics& statistics, const QString& unit)
{
  return MeasureTexts::tr("%1, from %2 to %3%4\n%5, %6 voxels")
    .arg(MeanText(statistics, unit), FourDigits(statistics.smallest),
      FourDigits(statistics.largest), unit, VolumeText(statistics.volumeMm3))
    .arg(statistics.voxels);
}

QString UnitOf(const LoadedVolume& volume)
{
  return volume.modality == "CT"     ? QStringLiteral(" HU")
    : volume.uptakeValueFactor > 0.0 ? QStringLiteral(" SUV")
                                     : QString();
}

// Statistics of uptake values, where they are known.
RegionStatistics InUnits(RegionStatistics statistics, const LoadedVolume& volume)
{
  const double factor = volume.uptakeValueFactor > 0.0 ? volume.uptakeValueFactor : 1.0;
  statistics.mean *= factor;
  statistics.standardDeviation *= factor;
  statistics.smallest *= factor;
  statistics.largest *= factor;
  return statistics;
}

// The value at a point: "HU 40", "SUV 2.35 (5868)" or "value 7".
QString ValueText(const LoadedVolume& volume, double value)
{
  const QString number = NumberText(value, 0);
  return volume.modality == "CT" ? MeasureTexts::tr("HU ") + number
    : volume.uptakeValueFactor > 0.0
    ? MeasureTexts::tr("SUV %1 (%2)").arg(NumberText(value * volume.uptakeValueFactor, 2), number)
    : MeasureTexts::tr("value ") + number;
}

// "; PET: SUV 2.35 (5868)" for each visible volume over the first at a point.
QString OverlayTexts(const Scene& scene, const Study& study, const std::array<double, 3>& pointMm)
{
  QString texts;
  for (std::size_t i = 0; i < scene.overlays.size(); ++i)
  {
    const LoadedVolume& volume = study.overlays[i]->volume;
    const auto value = ValueAt(Placed(volume.image, scene.overlays[i].placement), pointMm);
    if (value && scene.overlays[i].visible)
    {
      texts +=
        "; " + QString::fromStdString(scene.overlays[i].name) + ": " + ValueText(volume, *value);
    }
  }
  return texts;
}

// ", liver" in a visible segment of this name, otherwise empty.
QString SegmentText(
  const SceneLabels& labels, vtkImageData* numbers, const std::array<double, 3>& pointMm)
{
  std::array<double, 3> copy = pointMm; // VTK takes no constant
  const vtkIdType voxel = numbers->FindPoint(copy.data());
  const int number =
    voxel < 0 ? 0 : static_cast<const unsigned char*>(numbers->GetScalarPointer())[voxel];
  const bool isShown = number > 0 && labels.segments[number - 1].visible;
  return isShown ? ", " + QString::fromStdString(labels.segments[number - 1].name) : QString();
}

}

MeasureTexts::MeasureTexts(const Scene& scene, const LoadedVolume& volume)
{
  for (const Distance& distance : scene.distances)
  {
    this->distances.append(tr("%1 mm").arg(NumberText(LengthMm(distance), 1)));
  }
  for (const Angle& angle : scene.angles)
  {
    this->angles.append(tr("%1°").arg(NumberText(AngleDegrees(angle), 1)));
  }
  for (const MeasuredBox& box : scene.boxes)
  {
    const RegionStatistics statistics = StatisticsOf(box, volume.image);
    this->boxes.append(RegionText(statistics, volume));
    this->boxLabels.append(statistics.voxels == 0
        ? tr("no voxels")
        : MeanText(InUnits(statistics, volume), UnitOf(volume)) + '\n' +
          VolumeText(statistics.volumeMm3));
  }
}

QString VolumeText(double volumeMm3)
{
  return volumeMm3 < Mm3PerMl ? MeasureTexts::tr("%1 mm³").arg(NumberText(volumeMm3, 0))
                              : MeasureTexts::tr("%1 ml").arg(NumberText(volumeMm3 / Mm3PerMl, 2));
}

QString RegionText(const RegionStatistics& statistics, const LoadedVolume& volume)
{
  return statistics.voxels == 0 ? MeasureTexts::tr("no voxels")
                                : BoxText(InUnits(statistics, volume), UnitOf(volume));
}

QString PointText(const Scene& scene, const Study& study, const std::array<double, 3>& pointMm)
{
  const LoadedVolume& volume = study.volume;
  return MeasureTexts::tr("%1 at %2, %3, %4 mm")
           .arg(ValueText(volume, ValueAt(volume.image, pointMm).value_or(0.0)))
           .arg(NumberText(pointMm[0], 1))
           .arg(NumberText(pointMm[1], 1))
           .arg(NumberText(pointMm[2], 1)) +
    (scene.labels ? SegmentText(*scene.labels, study.labels->image, pointMm) : QString()) +
    OverlayTexts(scene, study, pointMm);
}

}
