#ifndef Varimarch_Viewer_StudyTexts_h
#define Varimarch_Viewer_StudyTexts_h

#include <QString>

namespace varimarch
{

/// A person's name as people write it: "Doe, Jane" for "Doe^Jane" (PS3.5 6.2.1.1).
QString PersonText(const QString& stored);

/// A date in the form of the user's language for DICOM's "20261126"; other texts stay.
QString DateText(const QString& stored);

}

#endif
