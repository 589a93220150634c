#include "Scene/MeasuresCsv.h"

#include "Scene/CsvText.h"
#include "Scene/MeasureKinds.h"
#include "Scene/MeasureUnits.h"
#include "Scene/VolumeLoading.h"

#include <limits>
#include <locale>
#include <sstream>

namespace varimarch
{

namespace
{

void WriteNumber(std::ostream& line, const std::optional<double>& number)
{
  line << ',';
  if (number)
  {
    line << *number;
  }
}

void WriteStatistics(
  std::ostream& line, const std::optional<RegionStatistics>& statistics, const std::string& unit)
{
  if (!statistics || statistics->voxels == 0)
  {
    line << ',' << (statistics ? "0" : "") << ",,,,,";
    return;
  }
  line << ',' << statistics->voxels << ',' << statistics->mean << ','
       << statistics->standardDeviation << ',' << statistics->smallest << ',' << statistics->largest
       << ',' << unit;
}

void WritePoints(std::ostream& line, const Measure& measure, int volume)
{
  line << ",\"";
  const char* separator = "";
  for (const auto& [x, y, z] : measure.pointsMm)
  {
    line << separator << x << ' ' << y << ' ' << z;
    separator = "; ";
  }
  line << "\"," << volume << '\n';
}

void WriteLine(std::ostream& text, int number, const Measure& measure, const MeasureValues& values,
  const PlacedVolume& of)
{
  text << number << ',' << TraitsOf(measure.kind).name << ',' << QuotedForCsv(measure.name);
  WriteNumber(text, values.lengthMm);
  WriteNumber(text, values.degrees);
  WriteNumber(text, values.areaMm2);
  WriteNumber(text, values.volumeMm3);
  WriteStatistics(text, values.statistics, UnitOf(of.volume));
  WritePoints(text, measure, of.number);
}

}

std::string CsvOf(const std::vector<Measure>& measures, const LoadedVolume& volume,
  const std::vector<PlacedVolume>& over)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<float>::max_digits10);
  text << "number,kind,name,length_mm,angle_degrees,area_mm2,volume_mm3,voxels,mean,"
          "standard_deviation,smallest,largest,unit,points_mm,volume\n";
  int number = 0;
  for (const Measure& measure : measures)
  {
    const MeasureValues values = ValuesOf(measure, volume.image);
    WriteLine(text, ++number, measure, InUnits(values, volume), { 1, volume, volume.image });
    for (const PlacedVolume& other : over)
    {
      if (const auto statistics = StatisticsOver(measure, volume.image, other.image))
      {
        MeasureValues ofOther = { {}, {}, values.areaMm2, {}, InUnits(*statistics, other.volume) };
        if (values.volumeMm3)
        {
          ofOther.volumeMm3 = statistics->volumeMm3;
        }
        WriteLine(text, number, measure, ofOther, other);
      }
    }
  }
  return text.str();
}

}
