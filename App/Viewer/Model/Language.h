#ifndef Varimarch_Viewer_Language_h
#define Varimarch_Viewer_Language_h

#include <QString>
#include <QVector>

class QCoreApplication;

namespace varimarch
{

struct Language
{
  QString code; ///< "de"; empty: the system's
  QString name; ///< in itself: "Deutsch"
};

/// Those that the program speaks, English first.
QVector<Language> Languages();

/// The user's choice, kept from one run of the program to the next.
QString ChosenLanguage();
void ChooseLanguage(const QString& code);

/// From now on widgets that are made speak a language; empty: the system's, if it is one of ours.
void Speak(const QString& code, QCoreApplication* application);

}

#endif
