#include "Viewer/Model/MeasureTexts.h"

#include "Scene/Measures.h"
#include "Scene/VolumeLoading.h"
#include "Viewer/Model/NumberText.h"

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
  const QString unit = volume.modality == "CT" ? QStringLiteral(" HU") : QString();
  for (const MeasuredBox& box : scene.boxes)
  {
    const RegionStatistics statistics = StatisticsOf(box, volume.image);
    const bool isEmpty = statistics.voxels == 0;
    this->boxes.append(isEmpty ? tr("no voxels") : BoxText(statistics, unit));
    this->boxLabels.append(isEmpty
        ? tr("no voxels")
        : MeanText(statistics, unit) + '\n' + VolumeText(statistics.volumeMm3));
  }
}

QString VolumeText(double volumeMm3)
{
  return volumeMm3 < Mm3PerMl ? MeasureTexts::tr("%1 mm³").arg(NumberText(volumeMm3, 0))
                              : MeasureTexts::tr("%1 ml").arg(NumberText(volumeMm3 / Mm3PerMl, 2));
}

}
