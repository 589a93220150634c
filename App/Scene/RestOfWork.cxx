#include "Scene/RestOfWork.h"

#include <iomanip>
#include <sstream>

namespace varimarch
{

std::string RestOfWork(double part, double elapsedSeconds)
{
  constexpr double LeastElapsed = 3.0;
  constexpr double Minute = 60.0;
  constexpr double MostMinutes = 120.0;
  const double minutes = part > 0.0 ? elapsedSeconds * (1.0 - part) / part / Minute : 0.0;
  if (elapsedSeconds < LeastElapsed || minutes < 1.0)
  {
    return "";
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << ", about ";
  minutes < MostMinutes ? text << minutes << " minutes left"
                        : text << minutes / 60.0 << " hours left";
  return text.str();
}

}
