#ifndef Varimarch_Readers_Dicom_Moment_h
#define Varimarch_Readers_Dicom_Moment_h

#include <optional>
#include <string>

namespace varimarch
{

/// Seconds since 1970 of a date and a time as DICOM writes them: "YYYYMMDD" and "HHMMSS" with an
/// optional fraction. A shorter time lacks minutes or seconds; what follows is ignored, such as a
/// time zone. Empty for shorter texts (PS3.5 table 6.2-1).
std::optional<double> SecondsOfMoment(const std::string& date, const std::string& time);

/// Seconds by which the local time is ahead of UTC, from the last five letters of a text, such as
/// "+0130"; empty if they are none of a time zone.
std::optional<double> SecondsOfZone(const std::string& text);

}

#endif
