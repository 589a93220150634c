#include "Viewer/Model/MeasureTexts.h"

#include "Scene/Measures.h"

namespace varimarch
{

namespace
{

constexpr double Mm3PerMl = 1000.0;

QString Number(double value)
{
  return QString::number(value, 'g', 4);
}

QString BoxText(const BoxStatistics& statistics)
{
  if (statistics.voxels == 0)
  {
    return MeasureTexts::tr("no voxels");
  }
  return MeasureTexts::tr("%1 ± %2, from %3 to %4\n%5, %6 voxels")
    .arg(Number(statistics.mean), Number(statistics.standardDeviation), Number(statistics.smallest),
      Number(statistics.largest), VolumeText(statistics.volumeMm3))
    .arg(statistics.voxels);
}

QString BoxLabel(const BoxStatistics& statistics)
{
  return statistics.voxels == 0
    ? MeasureTexts::tr("no voxels")
    : MeasureTexts::tr("%1 ± %2\n%3")
        .arg(Number(statistics.mean), Number(statistics.standardDeviation),
          VolumeText(statistics.volumeMm3));
}

}

MeasureTexts::MeasureTexts(const Scene& scene, vtkImageData* image)
{
  for (const Distance& distance : scene.distances)
  {
    this->distances.append(MeasureTexts::tr("%1 mm").arg(LengthMm(distance), 0, 'f', 1));
  }
  for (const Angle& angle : scene.angles)
  {
    this->angles.append(MeasureTexts::tr("%1°").arg(AngleDegrees(angle), 0, 'f', 1));
  }
  for (const MeasuredBox& box : scene.boxes)
  {
    const BoxStatistics statistics = StatisticsOf(box, image);
    this->boxes.append(BoxText(statistics));
    this->boxLabels.append(BoxLabel(statistics));
  }
}

QString VolumeText(double volumeMm3)
{
  return volumeMm3 < Mm3PerMl ? MeasureTexts::tr("%1 mm³").arg(volumeMm3, 0, 'f', 0)
                              : MeasureTexts::tr("%1 ml").arg(volumeMm3 / Mm3PerMl, 0, 'f', 2);
}

}
