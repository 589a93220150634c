#include "Regression/VtkDifferences.h"

#include "Scene/Files/OutputFile.h"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace
{

constexpr double Factor = 1.5;       ///< by which a difference may be larger or smaller
constexpr double RoundingRmse = 0.2; ///< difference by rounding alone [1/255]

std::string PathIn(const std::string& folder)
{
  return folder + "/VtkDifferences.csv";
}

double RecordedRmse(const std::string& folder, const std::string& name)
{
  std::ifstream table(PathIn(folder));
  std::string line;
  while (std::getline(table, line))
  {
    if (line.compare(0, name.size() + 1, name + ",") == 0)
    {
      return std::stod(line.substr(name.size() + 1));
    }
  }
  throw std::runtime_error(PathIn(folder) + ": no row of " + name +
    "; RegressionTests --write -D FOLDER --mapper vtk writes the table");
}

}

void WriteDifferencesOfVtk(const std::string& folder, const std::vector<VtkDifference>& differences)
{
  std::ostringstream table;
  table << "name,rmse_255,percentile_99_9_255\n" << std::fixed << std::setprecision(2);
  for (const auto& [name, error] : differences)
  {
    table << name << ',' << error.rootMeanSquare << ',' << error.percentile999 << '\n';
  }
  varimarch::WriteFileWhole(PathIn(folder), table.str());
}

std::string FaultsOfVtk(
  const std::string& folder, const std::string& name, const varimarch::ImageError& error)
{
  const double recorded = RecordedRmse(folder, name);
  const double drawn = error.rootMeanSquare;
  if (drawn <= Factor * recorded + RoundingRmse && recorded <= Factor * drawn + RoundingRmse)
  {
    return {};
  }
  std::ostringstream fault;
  fault << "The RMSE of VTK's mapper is " << drawn << " of 255, recorded are " << recorded << ". ";
  return fault.str();
}
