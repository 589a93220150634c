<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>ArchiveList</name>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>Password of %1 for %2. It is not kept.</source>
        <translation>Passwort von %1 für %2. Es wird nicht gespeichert.</translation>
    </message>
</context>
<context>
    <name>BrightnessTool</name>
    <message>
        <source>window and level</source>
        <translation>Fenster und Mitte</translation>
    </message>
</context>
<context>
    <name>CutHandles</name>
    <message>
        <source>push a plane</source>
        <translation>Ebene verschieben</translation>
    </message>
    <message>
        <source>rotate a plane</source>
        <translation>Ebene drehen</translation>
    </message>
    <message>
        <source>crop</source>
        <translation>beschneiden</translation>
    </message>
    <message>
        <source>move the box</source>
        <translation>Quader verschieben</translation>
    </message>
</context>
<context>
    <name>KeyImageTexts</name>
    <message>
        <source>Axial slice</source>
        <translation>Axiale Schicht</translation>
    </message>
    <message>
        <source>Coronal slice</source>
        <translation>Koronale Schicht</translation>
    </message>
    <message>
        <source>Sagittal slice</source>
        <translation>Sagittale Schicht</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
</context>
<context>
    <name>KeysDialog</name>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>the chosen tool; at first it rotates</source>
        <translation>das gewählte Werkzeug; zunächst dreht es</translation>
    </message>
    <message>
        <source>Drag with Ctrl</source>
        <translation>Ziehen mit Strg</translation>
    </message>
    <message>
        <source>window and level</source>
        <translation>Fenster und Mitte</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>Mittlere Taste</translation>
    </message>
    <message>
        <source>move the volume</source>
        <translation>das Volumen verschieben</translation>
    </message>
    <message>
        <source>Wheel, right button</source>
        <translation>Rad, rechte Taste</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>zoomen</translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>see this view alone, or all again</source>
        <translation>diese Ansicht allein zeigen oder wieder alle</translation>
    </message>
    <message>
        <source>revert a gesture that is not finished</source>
        <translation>eine begonnene Geste rückgängig machen</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>move the crosshair, or the chosen measurement</source>
        <translation>das Fadenkreuz bewegen, oder die gewählte Messung</translation>
    </message>
    <message>
        <source>Right button</source>
        <translation>Rechte Taste</translation>
    </message>
    <message>
        <source>move the slice</source>
        <translation>die Schicht verschieben</translation>
    </message>
    <message>
        <source>Wheel, arrow and page keys</source>
        <translation>Rad, Pfeil- und Bildtasten</translation>
    </message>
    <message>
        <source>the next slices</source>
        <translation>die nächsten Schichten</translation>
    </message>
    <message>
        <source>Ctrl with wheel, + and -</source>
        <translation>Strg mit Rad, + und -</translation>
    </message>
    <message>
        <source>zoom; Home shows the whole slice</source>
        <translation>zoomen; Pos1 zeigt die ganze Schicht</translation>
    </message>
    <message>
        <source>a usual window for CT; 0 is that of the file</source>
        <translation>ein übliches CT-Fenster; 0 ist das der Datei</translation>
    </message>
    <message>
        <source>Curve of the look</source>
        <translation>Kurve der Darstellung</translation>
    </message>
    <message>
        <source>Drag a point</source>
        <translation>Punkt ziehen</translation>
    </message>
    <message>
        <source>change its value and opacity</source>
        <translation>Wert und Deckkraft ändern</translation>
    </message>
    <message>
        <source>Click the curve</source>
        <translation>Kurve anklicken</translation>
    </message>
    <message>
        <source>add a point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Double-click a point</source>
        <translation>Punkt doppelklicken</translation>
    </message>
    <message>
        <source>type its numbers</source>
        <translation>Zahlen eingeben</translation>
    </message>
    <message>
        <source>choose its colour</source>
        <translation>Farbe wählen</translation>
    </message>
    <message>
        <source>Menus</source>
        <translation>Menüs</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>walk, with the tool Walk; arrow and page keys too</source>
        <translation>gehen, mit dem Werkzeug Gehen; auch Pfeil- und Bildtasten</translation>
    </message>
    <message>
        <source>Drag a line of the crosshair</source>
        <translation>Eine Linie des Fadenkreuzes ziehen</translation>
    </message>
    <message>
        <source>turn the other slices</source>
        <translation>die anderen Schichten drehen</translation>
    </message>
</context>
<context>
    <name>MeasureReport</name>
    <message>
        <source>A box lies along the axes of the first scan, and this one has others. Remove the boxes, or save a table.</source>
        <translation>Ein Quader liegt entlang der Achsen der ersten Aufnahme, und diese hat andere. Entfernen Sie die Quader, oder speichern Sie eine Tabelle.</translation>
    </message>
</context>
<context>
    <name>MeasureTexts</name>
    <message>
        <source>Volume %1</source>
        <translation>Volumen %1</translation>
    </message>
    <message>
        <source>no voxels</source>
        <translation>keine Voxel</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 mm³</source>
        <translation>%1 mm³</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>mean %1 ± %2%3</source>
        <translation>Mittel %1 ± %2%3</translation>
    </message>
    <message>
        <source>HU </source>
        <translation>HE </translation>
    </message>
    <message>
        <source>value </source>
        <translation>Wert </translation>
    </message>
    <message>
        <source>SUV %1 (%2)</source>
        <translation>SUV %1 (%2)</translation>
    </message>
    <message>
        <source>%1 at %2, %3, %4 mm</source>
        <translation>%1 bei %2, %3, %4 mm</translation>
    </message>
    <message>
        <source>%1, from %2 to %3%4</source>
        <translation>%1, von %2 bis %3%4</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 Pixel</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 Voxel</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Cobb angle</source>
        <translation>Cobb-Winkel</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Freehand region</source>
        <translation>Freihand-Region</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Pfeil</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source> HU</source>
        <translation> HE</translation>
    </message>
</context>
<context>
    <name>MeasureTool</name>
    <message>
        <source>measure</source>
        <translation>messen</translation>
    </message>
</context>
<context>
    <name>OpenGLProblem</name>
    <message>
        <source>OpenGL 3.2 or later is needed, found %1; install or update the driver of the graphics card, or the package libgl1-mesa-dri, which draws without one</source>
        <translation>OpenGL 3.2 oder neuer wird gebraucht, gefunden wurde %1; installieren oder aktualisieren Sie den Treiber der Grafikkarte oder das Paket libgl1-mesa-dri, das ohne sie zeichnet</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>a display without GLX</source>
        <translation>eine Anzeige ohne GLX</translation>
    </message>
</context>
<context>
    <name>OwnPresets</name>
    <message>
        <source>My look %1</source>
        <translation>Meine Darstellung %1</translation>
    </message>
    <message>
        <source>A preset name must not begin with a dot or contain a slash.</source>
        <translation>Der Name einer Vorlage darf nicht mit einem Punkt beginnen und keinen Schrägstrich enthalten.</translation>
    </message>
    <message>
        <source>A preset named %1 already exists.</source>
        <translation>Eine Vorlage namens %1 gibt es schon.</translation>
    </message>
    <message>
        <source>Cannot rename the preset %1 to %2.</source>
        <translation>Die Vorlage %1 lässt sich nicht in %2 umbenennen.</translation>
    </message>
    <message>
        <source>Cannot remove the preset %1.</source>
        <translation>Die Vorlage %1 lässt sich nicht entfernen.</translation>
    </message>
</context>
<context>
    <name>PdfPages</name>
    <message>
        <source>Not for diagnostic use: made by a program that is not a medical device</source>
        <translation>Nicht für die Diagnose: von einem Programm, das kein Medizinprodukt ist</translation>
    </message>
</context>
<context>
    <name>PictureExport</name>
    <message>
        <source>Not for diagnostic use</source>
        <translation>Nicht für die Diagnose</translation>
    </message>
</context>
<context>
    <name>PictureReport</name>
    <message>
        <source>VTK, GPU</source>
        <translation>VTK, GPU</translation>
    </message>
    <message>
        <source>VTK, CPU</source>
        <translation>VTK, CPU</translation>
    </message>
    <message>
        <source>%1
%2
error unknown</source>
        <translation>%1
%2
Fehler unbekannt</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>error about %1 %</source>
        <translation>Fehler etwa %1 %</translation>
    </message>
    <message>
        <source>
except at single pixels</source>
        <translation>
außer bei einzelnen Pixeln</translation>
    </message>
    <message>
        <source>
mean of %1 frames</source>
        <translation>
Mittel von %1 Bildern</translation>
    </message>
    <message>
        <source>error at most 1/%1, refined</source>
        <translation>Fehler höchstens 1/%1, fertig verfeinert</translation>
    </message>
    <message>
        <source>error at most 1/%1</source>
        <translation>Fehler höchstens 1/%1</translation>
    </message>
    <message>
        <source>coarse voxels, error unknown</source>
        <translation>grobe Voxel, Fehler unbekannt</translation>
    </message>
    <message>
        <source>error at most %1 %, refining</source>
        <translation>Fehler höchstens %1 %, wird verfeinert</translation>
    </message>
    <message>
        <source>error not bounded</source>
        <translation>Fehler nicht begrenzt</translation>
    </message>
    <message>
        <source>
Less error takes long, since its voxels do not fit in the memory:
allow more in the menu File, or zoom in.</source>
        <translation>
Weniger Fehler dauert lange, da seine Voxel nicht in den Arbeitsspeicher passen:
Erlauben Sie im Menü Datei mehr davon, oder zoomen Sie hinein.</translation>
    </message>
    <message>
        <source>Nothing is visible: %1.</source>
        <translation>Nichts ist zu sehen: %1.</translation>
    </message>
    <message>
        <source>masks not supported</source>
        <translation>Masken nicht unterstützt</translation>
    </message>
    <message>
        <source>segments not supported</source>
        <translation>kennt keine Segmente</translation>
    </message>
    <message>
        <source>regions not supported</source>
        <translation>kennt keine Regionen</translation>
    </message>
    <message>
        <source>blend mode not supported</source>
        <translation>kennt diese Mischung nicht</translation>
    </message>
    <message>
        <source>further scans not supported</source>
        <translation>kennt keine weiteren Aufnahmen</translation>
    </message>
    <message>
        <source>shadows not supported</source>
        <translation>kennt keine Schatten</translation>
    </message>
    <message>
        <source>cubic interpolation not supported</source>
        <translation>kennt keine kubische Interpolation</translation>
    </message>
    <message>
        <source>refining, %1 %</source>
        <translation>wird verfeinert, %1 %</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>in Bewegung</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
</context>
<context>
    <name>PresetTitles</name>
    <message>
        <source>CT airways</source>
        <translation>CT Atemwege</translation>
    </message>
    <message>
        <source>CT bone</source>
        <translation>CT Knochen</translation>
    </message>
    <message>
        <source>CT implants</source>
        <translation>CT Implantate</translation>
    </message>
    <message>
        <source>CT lungs</source>
        <translation>CT Lunge</translation>
    </message>
    <message>
        <source>CT maximum</source>
        <translation>CT Maximum</translation>
    </message>
    <message>
        <source>CT skin</source>
        <translation>CT Haut</translation>
    </message>
    <message>
        <source>CT soft tissue</source>
        <translation>CT Weichteile</translation>
    </message>
    <message>
        <source>CT vessels</source>
        <translation>CT Gefäße</translation>
    </message>
    <message>
        <source>MR angiography</source>
        <translation>MR Angiographie</translation>
    </message>
    <message>
        <source>MR head, T1</source>
        <translation>MR Kopf, T1</translation>
    </message>
    <message>
        <source>MR maximum</source>
        <translation>MR Maximum</translation>
    </message>
    <message>
        <source>MR head, T2</source>
        <translation>MR Kopf, T2</translation>
    </message>
    <message>
        <source>the modality is %1</source>
        <translation>die Modalität ist %1</translation>
    </message>
    <message>
        <source>the body part is %1</source>
        <translation>die Körperregion ist %1</translation>
    </message>
    <message>
        <source>the file mentions a contrast agent</source>
        <translation>die Datei nennt ein Kontrastmittel</translation>
    </message>
    <message>
        <source>the sequence times in the file suggest %1</source>
        <translation>die Sequenzzeiten in der Datei sprechen für %1</translation>
    </message>
    <message>
        <source>it contains metal, denser than any bone</source>
        <translation>es enthält Metall, dichter als jeder Knochen</translation>
    </message>
    <message>
        <source>its values reach down to air in CT</source>
        <translation>seine Werte reichen bis zu denen von Luft im CT</translation>
    </message>
    <message>
        <source>its values do not look like CT</source>
        <translation>seine Werte sehen nicht nach CT aus</translation>
    </message>
    <message>
        <source>PET maximum</source>
        <translation>PET Maximum</translation>
    </message>
    <message>
        <source>the body part is %1, but the file&apos;s window is for soft tissue</source>
        <translation>die Körperregion ist %1, aber das Fenster der Datei ist für Weichteile</translation>
    </message>
    <message>
        <source>the body part is %1, but few values are those of lungs</source>
        <translation>die Körperregion ist %1, aber wenige Werte sind die von Lungen</translation>
    </message>
    <message>
        <source>PET hot</source>
        <translation>PET heiß</translation>
    </message>
</context>
<context>
    <name>RecentScans</name>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>opened %1</source>
        <translation>geöffnet %1</translation>
    </message>
</context>
<context>
    <name>ScanReport</name>
    <message>
        <source>custom look</source>
        <translation>eigene Darstellung</translation>
    </message>
    <message>
        <source>%1, edited</source>
        <translation>%1, bearbeitet</translation>
    </message>
    <message>
        <source>ambient %1, diffuse %2, specular %3, power %4</source>
        <translation>Umgebung %1, diffus %2, Glanz %3, Schärfe %4</translation>
    </message>
    <message>
        <source>none: unshaded colours</source>
        <translation>keines: unschattierte Farben</translation>
    </message>
    <message>
        <source>at most 1/%1 of full brightness in any colour of 99.9 % of the pixels, estimated</source>
        <translation>höchstens 1/%1 der vollen Helligkeit in jeder Farbe von 99,9 % der Pixel, geschätzt</translation>
    </message>
    <message>
        <source>not bounded</source>
        <translation>nicht begrenzt</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Voxel spacing</source>
        <translation>Voxelabstand</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation>Mischung</translation>
    </message>
    <message>
        <source>Opacity per</source>
        <translation>Deckkraft je</translation>
    </message>
    <message>
        <source>Opacity by gradient</source>
        <translation>Deckkraft nach Gradient</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Cut planes</source>
        <translation>Schnittebenen</translation>
    </message>
    <message>
        <source>Scissors cuts</source>
        <translation>Schnitte mit der Schere</translation>
    </message>
    <message>
        <source>%1, a coarse copy of the volume</source>
        <translation>%1, eine grobe Kopie des Volumens</translation>
    </message>
    <message>
        <source>Promised error</source>
        <translation>Zugesagter Fehler</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Volume report</source>
        <translation>Bericht zum Volumen</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Rendering settings</source>
        <translation>Einstellungen der Darstellung</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>Table and clothes</source>
        <translation>Tisch und Kleidung</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Schlüsselbilder</translation>
    </message>
    <message>
        <source>Segments of volume %1</source>
        <translation>Segmente von Volumen %1</translation>
    </message>
</context>
<context>
    <name>ScissorsTool</name>
    <message>
        <source>keep the inside</source>
        <translation>das Innere behalten</translation>
    </message>
    <message>
        <source>cut out</source>
        <translation>ausschneiden</translation>
    </message>
</context>
<context>
    <name>SliceCorners</name>
    <message>
        <source>W %1 L %2</source>
        <translation>F %1 M %2</translation>
    </message>
    <message>
        <source>Zoom %1 %</source>
        <translation>Zoom %1 %</translation>
    </message>
    <message>
        <source>Slice %1 of %2</source>
        <translation>Schicht %1 von %2</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %2 mm</translation>
    </message>
    <message>
        <source>Slab %1 mm</source>
        <translation>Dicke %1 mm</translation>
    </message>
    <message>
        <source>%1 µm</source>
        <translation>%1 µm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>Schräg</translation>
    </message>
</context>
<context>
    <name>SliceView</name>
    <message>
        <source>window and level</source>
        <translation>Fenster und Mitte</translation>
    </message>
</context>
<context>
    <name>SliceWindows</name>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Lungs</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Mediastinum</source>
        <translation>Mediastinum</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Gehirn</translation>
    </message>
    <message>
        <source>Subdural</source>
        <translation>Subdural</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Schlaganfall</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
</context>
<context>
    <name>StudyIndex</name>
    <message>
        <source>The study list &quot;%1&quot; cannot be used: %2. Remove the list and add its folders again.</source>
        <translation>Die Studienliste „%1“ ist nicht benutzbar: %2. Entfernen Sie die Liste und fügen Sie die Ordner wieder hinzu.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be read: it is not there, or its disk is away. What the list knows of it stays.</source>
        <translation>Der Ordner „%1“ ist nicht lesbar: Es gibt ihn nicht, oder sein Laufwerk fehlt. Seine Einträge bleiben in der Liste.</translation>
    </message>
</context>
<context>
    <name>Theme</name>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>As on the &amp;desktop</source>
        <translation>Wie auf dem &amp;Schreibtisch</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>High &amp;contrast</source>
        <translation>Hoher &amp;Kontrast</translation>
    </message>
</context>
<context>
    <name>TimeTexts</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 s, %2</source>
        <translation>%1 s, %2</translation>
    </message>
    <message>
        <source>A movie lasts at most an hour, and this one would be longer. Choose a speed beside the slider of the times.</source>
        <translation>Ein Film dauert höchstens eine Stunde, und dieser wäre länger. Wählen Sie eine Geschwindigkeit neben dem Regler der Zeitpunkte.</translation>
    </message>
</context>
<context>
    <name>TransferFunctionEditor</name>
    <message>
        <source>opacity %1</source>
        <translation>Deckkraft %1</translation>
    </message>
    <message>
        <source>%1 % of voxels, %2 % above</source>
        <translation>%1 % der Voxel, %2 % darüber</translation>
    </message>
    <message>
        <source>point %1 of %2, %3, %4</source>
        <translation>Punkt %1 von %2, %3, %4</translation>
    </message>
    <message>
        <source>surface %1 of %2, %3, %4</source>
        <translation>Fläche %1 von %2, %3, %4</translation>
    </message>
    <message>
        <source>colour %1 of %2, %3</source>
        <translation>Farbe %1 von %2, %3</translation>
    </message>
</context>
<context>
    <name>Turntable</name>
    <message>
        <source>the disk is full, or its end was not written</source>
        <translation>die Platte ist voll, oder das Ende wurde nicht geschrieben</translation>
    </message>
    <message>
        <source>Cannot write %1</source>
        <translation>%1 lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>ffmpeg could not be started: %1</source>
        <translation>ffmpeg konnte nicht gestartet werden: %1</translation>
    </message>
    <message>
        <source>MP4 needs the program ffmpeg, which is not installed</source>
        <translation>MP4 braucht das Programm ffmpeg, das nicht installiert ist</translation>
    </message>
    <message>
        <source>ffmpeg exited with code %1</source>
        <translation>ffmpeg endete mit dem Code %1</translation>
    </message>
    <message>
        <source>ffmpeg reports: %1</source>
        <translation>ffmpeg meldet: %1</translation>
    </message>
    <message>
        <source>Movie, MP4 (*.mp4)</source>
        <translation>Film, MP4 (*.mp4)</translation>
    </message>
    <message>
        <source>Movie, Ogg Theora (*.ogv)</source>
        <translation>Film, Ogg Theora (*.ogv)</translation>
    </message>
    <message>
        <source>Images (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Cannot write %1: %2</source>
        <translation>%1 lässt sich nicht schreiben: %2</translation>
    </message>
</context>
<context>
    <name>WalkTool</name>
    <message>
        <source>walk</source>
        <translation>gehen</translation>
    </message>
</context>
<context>
    <name>WordsEditor</name>
    <message>
        <source>Words</source>
        <translation>Worte</translation>
    </message>
</context>
<context>
    <name>varimarch::ArchiveChoice</name>
    <message>
        <source>Edit…</source>
        <translation>Bearbeiten…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen…</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
</context>
<context>
    <name>varimarch::ArchiveForm</name>
    <message>
        <source>A file in PEM with our certificate and its private key without a password, if the archive asks for it; encrypted C-MOVE needs it</source>
        <translation>Eine PEM-Datei mit unserem Zertifikat und dessen privatem Schlüssel ohne Passwort, falls das Archiv danach fragt; verschlüsseltes C-MOVE braucht sie</translation>
    </message>
    <message>
        <source>Our certificate</source>
        <translation>Unser Zertifikat</translation>
    </message>
    <message>
        <source>Encrypted (TLS)</source>
        <translation>Verschlüsselt (TLS)</translation>
    </message>
    <message>
        <source>Set up an archive</source>
        <translation>Archiv einrichten</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Testen</translation>
    </message>
    <message>
        <source>Asks the archive to answer</source>
        <translation>Bittet das Archiv um eine Antwort</translation>
    </message>
    <message>
        <source>DICOM (C-FIND, C-GET, C-STORE)</source>
        <translation>DICOM (C-FIND, C-GET, C-STORE)</translation>
    </message>
    <message>
        <source>DICOMweb</source>
        <translation>DICOMweb</translation>
    </message>
    <message>
        <source>none, by C-GET</source>
        <translation>keiner, mit C-GET</translation>
    </message>
    <message>
        <source>For archives that send only by C-MOVE, to a port that they know by our title</source>
        <translation>Für Archive, die nur mit C-MOVE senden, an einen Port, den sie unter unserem Titel kennen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>The password is asked for when it is needed, and is not kept</source>
        <translation>Das Passwort wird bei Bedarf erfragt und nicht gespeichert</translation>
    </message>
    <message>
        <source>file in PEM; none for a known authority</source>
        <translation>PEM-Datei; keine bei einer bekannten Zertifizierungsstelle</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>URL</source>
        <translation>URL</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Title of the archive (AE)</source>
        <translation>Titel des Archivs (AE)</translation>
    </message>
    <message>
        <source>Our title (AE)</source>
        <translation>Unser Titel (AE)</translation>
    </message>
    <message>
        <source>Port for C-MOVE</source>
        <translation>Port für C-MOVE</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Zertifikat</translation>
    </message>
    <message>
        <source>Waiting for the archive…</source>
        <translation>Warten auf das Archiv…</translation>
    </message>
    <message>
        <source>The archive answers.</source>
        <translation>Das Archiv antwortet.</translation>
    </message>
</context>
<context>
    <name>varimarch::ArchiveWindow</name>
    <message>
        <source>Unreadable name</source>
        <translation>Name nicht lesbar</translation>
    </message>
    <message>
        <source>Texts of %1 entries are left out: they are in an unknown set of characters, or in another than the archive says.</source>
        <translation>Texte von %1 Einträgen fehlen: Sie sind in einem unbekannten Zeichensatz oder in einem anderen, als das Archiv angibt.</translation>
    </message>
    <message>
        <source>No name</source>
        <translation>Kein Name</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Search for studies. What you open is deleted at the end, unless you keep it.</source>
        <translation>Suchen Sie nach Studien. Was Sie öffnen, wird am Ende gelöscht, wenn Sie es nicht behalten.</translation>
    </message>
    <message>
        <source>Add an archive (PACS) first. Its administrator knows host, port and titles.</source>
        <translation>Fügen Sie zuerst ein Archiv (PACS) hinzu. Rechner, Port und Titel kennt dessen Administrator.</translation>
    </message>
    <message>
        <source>It was cancelled</source>
        <translation>Es wurde abgebrochen</translation>
    </message>
    <message>
        <source>beginning, as DOE</source>
        <translation>Anfang, wie MEI</translation>
    </message>
    <message>
        <source>20261126, or 20260101-20261231</source>
        <translation>20261126 oder 20260101-20261231</translation>
    </message>
    <message>
        <source>CT, MR …</source>
        <translation>CT, MR …</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Keep in…</source>
        <translation>Behalten in…</translation>
    </message>
    <message>
        <source>Fetches the study or the series into a folder of yours, and opens it</source>
        <translation>Holt die Studie oder Serie in einen Ihrer Ordner und öffnet sie</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Fetches the study or the series, which is deleted at the end</source>
        <translation>Holt die Studie oder Serie, die am Ende gelöscht wird</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Suche…</translation>
    </message>
    <message>
        <source>Studies: %1</source>
        <translation>Studien: %1</translation>
    </message>
    <message>
        <source>Series: %1</source>
        <translation>Serien: %1</translation>
    </message>
    <message>
        <source>Keep the scan in a folder</source>
        <translation>Aufnahme in einem Ordner behalten</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be made; choose another.</source>
        <translation>Der Ordner „%1“ lässt sich nicht anlegen; wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>Choose a study or a series first.</source>
        <translation>Wählen Sie zuerst eine Studie oder Serie.</translation>
    </message>
    <message>
        <source>Fetching…</source>
        <translation>Übertragung…</translation>
    </message>
    <message>
        <source>Fetched</source>
        <translation>Übertragen</translation>
    </message>
</context>
<context>
    <name>varimarch::BackgroundTask</name>
    <message>
        <source>There is not enough memory.</source>
        <translation>Der Speicher reicht nicht.</translation>
    </message>
</context>
<context>
    <name>varimarch::BenchmarkDialog</name>
    <message>
        <source>Median of %1 views: ours %2 ms, %3 %4 ms, %5 times as long. Difference: RMSE %6, largest %7, in 1/255.</source>
        <translation>Median von %1 Ansichten: unserer %2 ms, %3 %4 ms, %5-mal so lange. Unterschied: RMSE %6, größter %7, in 1/255.</translation>
    </message>
    <message>
        <source>Angle [°]</source>
        <translation>Winkel [°]</translation>
    </message>
    <message>
        <source>Ours [ms]</source>
        <translation>Unserer [ms]</translation>
    </message>
    <message>
        <source>VTK&apos;s [ms]</source>
        <translation>VTKs [ms]</translation>
    </message>
    <message>
        <source>RMSE</source>
        <translation>RMSE</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größter</translation>
    </message>
    <message>
        <source>Benchmark</source>
        <translation>Leistungsvergleich</translation>
    </message>
    <message>
        <source>Renders the scene from all around with our mapper and with VTK&apos;s, and compares times and images.</source>
        <translation>Zeichnet die Szene ringsum mit unserem und mit VTKs Mapper und vergleicht Zeiten und Bilder.</translation>
    </message>
    <message>
        <source>VTK&apos;s GPU mapper</source>
        <translation>VTKs GPU-Mapper</translation>
    </message>
    <message>
        <source>VTK&apos;s CPU mapper</source>
        <translation>VTKs CPU-Mapper</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>Number of views</source>
        <translation>Anzahl der Ansichten</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>VTK&apos;s CPU mapper does not support this blend mode; choose VTK&apos;s GPU mapper.</source>
        <translation>VTKs CPU-Mapper beherrscht diese Mischung nicht; VTKs GPU-Mapper wählen.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Export the benchmark</source>
        <translation>Leistungsvergleich exportieren</translation>
    </message>
    <message>
        <source>Cannot export</source>
        <translation>Export nicht möglich</translation>
    </message>
    <message>
        <source>A turn around a volume of %1 x %2 x %3 voxels, rendered at %4 x %5 pixels by our mapper and by %6.</source>
        <translation>Eine Drehung um ein Volumen von %1 x %2 x %3 Voxeln, gezeichnet mit %4 x %5 Pixeln von unserem Mapper und von %6.</translation>
    </message>
    <message>
        <source>Report (*.pdf)</source>
        <translation>Bericht (*.pdf)</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>VTK&apos;s CPU mapper does not support segments; choose VTK&apos;s GPU mapper.</source>
        <translation>VTKs CPU-Mapper beherrscht Segmente nicht; VTKs GPU-Mapper wählen.</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
</context>
<context>
    <name>varimarch::BlendingForm</name>
    <message>
        <source>Composite</source>
        <translation>Überlagerung</translation>
    </message>
    <message>
        <source>Translucent material with the opacities of the curve</source>
        <translation>Durchscheinendes Material mit der Deckkraft der Kurve</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>The largest value along each ray: vessels, implants (MIP)</source>
        <translation>Der größte Wert auf jedem Strahl: Gefäße, Implantate (MIP)</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>The smallest value along each ray: airways (MinIP)</source>
        <translation>Der kleinste Wert auf jedem Strahl: Atemwege (MinIP)</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>The mean along each ray, as in a thick slice</source>
        <translation>Das Mittel auf jedem Strahl: wie eine dicke Schicht</translation>
    </message>
    <message>
        <source>Additive</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>The sum along each ray, as in an X-ray image</source>
        <translation>Die Summe auf jedem Strahl: wie ein Röntgenbild</translation>
    </message>
    <message>
        <source>Isosurfaces</source>
        <translation>Isoflächen</translation>
    </message>
    <message>
        <source>Surfaces of equal value, each with its colour and opacity</source>
        <translation>Flächen gleichen Werts, jede mit ihrer Farbe und Deckkraft</translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation>Mischung</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Thickness of material that has the opacities of the curve</source>
        <translation>Die Dicke des Materials, die die Deckkraft der Kurve hat</translation>
    </message>
    <message>
        <source>opacity distance</source>
        <translation>Strecke der Deckkraft</translation>
    </message>
    <message>
        <source>Opacity per</source>
        <translation>Deckkraft je</translation>
    </message>
    <message>
        <source>Values outside this range do not count in the mean</source>
        <translation>Werte außerhalb dieses Bereichs zählen im Mittel nicht</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Values from</source>
        <translation>Werte von</translation>
    </message>
    <message>
        <source>blend mode</source>
        <translation>Mischung</translation>
    </message>
    <message>
        <source>range of averaged values</source>
        <translation>Bereich der gemittelten Werte</translation>
    </message>
    <message>
        <source>Smallest value of the mean</source>
        <translation>Kleinster Wert des Mittels</translation>
    </message>
    <message>
        <source>Largest value of the mean</source>
        <translation>Größter Wert des Mittels</translation>
    </message>
    <message>
        <source>. Presets set it by the size of the volume, which is not known to show a patient</source>
        <translation>. Die Vorlagen richten sie nach der Größe des Volumens, von dem nicht bekannt ist, ob es einen Patienten zeigt</translation>
    </message>
</context>
<context>
    <name>varimarch::ChannelsBox</name>
    <message>
        <source>The volume is drawn in its own colours. The curve is their opacity.</source>
        <translation>Das Volumen hat seine eigenen Farben. Die Kurve ist ihre Deckkraft.</translation>
    </message>
    <message>
        <source>Draws the channel</source>
        <translation>Zeichnet den Kanal</translation>
    </message>
    <message>
        <source>Colour of the channel</source>
        <translation>Farbe des Kanals</translation>
    </message>
    <message>
        <source>Colour of channel %1</source>
        <translation>Farbe von Kanal %1</translation>
    </message>
    <message>
        <source>Opacity of channel %1</source>
        <translation>Deckkraft von Kanal %1</translation>
    </message>
    <message>
        <source>Factor of the opacities of the curve</source>
        <translation>Faktor der Deckkraft der Kurve</translation>
    </message>
    <message>
        <source>channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>opacity of a channel</source>
        <translation>Deckkraft eines Kanals</translation>
    </message>
    <message>
        <source>Values from</source>
        <translation>Werte von</translation>
    </message>
    <message>
        <source>First value of channel %1</source>
        <translation>Erster Wert von Kanal %1</translation>
    </message>
    <message>
        <source>Last value of channel %1</source>
        <translation>Letzter Wert von Kanal %1</translation>
    </message>
    <message>
        <source>The curve reaches from the first to the last of these values</source>
        <translation>Die Kurve reicht vom ersten bis zum letzten dieser Werte</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>values of a channel</source>
        <translation>Werte eines Kanals</translation>
    </message>
    <message>
        <source>colour of a channel</source>
        <translation>Farbe eines Kanals</translation>
    </message>
    <message>
        <source>Channel %1</source>
        <translation>Kanal %1</translation>
    </message>
</context>
<context>
    <name>varimarch::ClippingRangeBox</name>
    <message>
        <source>Distance from the eye</source>
        <translation>Abstand vom Auge</translation>
    </message>
    <message>
        <source>Shows only what lies between two distances from the eye</source>
        <translation>Zeigt nur, was zwischen zwei Abständen vom Auge liegt</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>Kleinster</translation>
    </message>
    <message>
        <source>Farthest</source>
        <translation>Größter</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>distance from the eye</source>
        <translation>Abstand vom Auge</translation>
    </message>
    <message>
        <source>limit the distance from the eye</source>
        <translation>Abstand vom Auge begrenzen</translation>
    </message>
    <message>
        <source>show all distances</source>
        <translation>alle Abstände zeigen</translation>
    </message>
</context>
<context>
    <name>varimarch::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Some letters of the command, such as &quot;panel look&quot;</source>
        <translation>Einige Buchstaben des Befehls, etwa „dar bedi“</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>varimarch::ComparisonView</name>
    <message>
        <source>Divider between our image and VTK&apos;s</source>
        <translation>Trennlinie zwischen unserem und VTKs Bild</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>RMSE %1, largest %2, in 1/255. Ours %3 ms, VTK&apos;s %4 ms.</source>
        <translation>RMSE %1, größter %2, in 1/255. Unseres %3 ms, VTKs %4 ms.</translation>
    </message>
    <message>
        <source>Difference (out of date)</source>
        <translation>Unterschied (veraltet)</translation>
    </message>
    <message>
        <source>No difference</source>
        <translation>Kein Unterschied angezeigt</translation>
    </message>
    <message>
        <source>There is no difference, because VTK&apos;s mapper does not draw the whole scene: %1.</source>
        <translation>Ein Unterschied wird nicht berechnet, weil VTKs Mapper nicht die ganze Szene zeichnet: %1.</translation>
    </message>
</context>
<context>
    <name>varimarch::CurvedView</name>
    <message>
        <source>Volume along the curve</source>
        <translation>Volumen entlang der Kurve</translation>
    </message>
    <message>
        <source>Choose Annotate, Curve, and click along a vessel or the jaw in the slices.</source>
        <translation>Wählen Sie Beschriften, Kurve, und klicken Sie in den Schichten an einem Gefäß oder dem Kiefer entlang.</translation>
    </message>
    <message>
        <source>%1 mm, turned by %2°</source>
        <translation>%1 mm, gedreht um %2°</translation>
    </message>
    <message>
        <source>, slab %1 mm</source>
        <translation>, Dicke %1 mm</translation>
    </message>
    <message>
        <source>%1 mm along the curve; %2</source>
        <translation>%1 mm entlang der Kurve; %2</translation>
    </message>
    <message>
        <source>move the crosshair</source>
        <translation>Fadenkreuz bewegen</translation>
    </message>
    <message>
        <source>turn the cut about the curve</source>
        <translation>Schnitt um die Kurve drehen</translation>
    </message>
    <message>
        <source>Straightened</source>
        <translation>Begradigt</translation>
    </message>
    <message>
        <source>Stretched</source>
        <translation>Gestreckt</translation>
    </message>
    <message>
        <source>The context menu chooses between the straightened and the stretched volume</source>
        <translation>Das Kontextmenü wählt zwischen dem begradigten und dem gestreckten Volumen</translation>
    </message>
    <message>
        <source>, stretched</source>
        <translation>, gestreckt</translation>
    </message>
</context>
<context>
    <name>varimarch::CutsPanel</name>
    <message>
        <source>side %1 cut away</source>
        <translation>Seite %1 weggeschnitten</translation>
    </message>
    <message>
        <source>Cut away the left half</source>
        <translation>Linke Hälfte wegschneiden</translation>
    </message>
    <message>
        <source>Cut away the right half</source>
        <translation>Rechte Hälfte wegschneiden</translation>
    </message>
    <message>
        <source>Cut away the front half</source>
        <translation>Vordere Hälfte wegschneiden</translation>
    </message>
    <message>
        <source>Cut away the back half</source>
        <translation>Hintere Hälfte wegschneiden</translation>
    </message>
    <message>
        <source>Cut away the upper half</source>
        <translation>Obere Hälfte wegschneiden</translation>
    </message>
    <message>
        <source>Cut away the lower half</source>
        <translation>Untere Hälfte wegschneiden</translation>
    </message>
    <message>
        <source>Cut away the half facing me</source>
        <translation>Mir zugewandte Hälfte wegschneiden</translation>
    </message>
    <message>
        <source>Cut away…</source>
        <translation>Wegschneiden…</translation>
    </message>
    <message numerus="yes">
        <source>Adds a plane that cuts away one side, up to %n planes</source>
        <translation>
            <numerusform>Eine Ebene schneidet eine Seite weg, bis zu %n davon</numerusform>
            <numerusform>Eine Ebene schneidet eine Seite weg, bis zu %n davon</numerusform>
        </translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Depth of the plane</source>
        <translation>Tiefe der Ebene</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Whole volume</source>
        <translation>Das ganze Volumen</translation>
    </message>
    <message>
        <source>show the whole volume</source>
        <translation>ganzes Volumen zeigen</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>Remove all cuts</source>
        <translation>Alle Schnitte entfernen</translation>
    </message>
    <message>
        <source>remove all scissors cuts</source>
        <translation>alle Scherenschnitte entfernen</translation>
    </message>
    <message>
        <source>Scissors cuts: %1</source>
        <translation>Schnitte mit der Schere: %1</translation>
    </message>
    <message>
        <source>cut away the half facing me</source>
        <translation>mir zugewandte Hälfte wegschneiden</translation>
    </message>
    <message>
        <source>move a plane</source>
        <translation>Ebene bewegen</translation>
    </message>
    <message>
        <source>flip a plane</source>
        <translation>Ebene umkehren</translation>
    </message>
    <message>
        <source>remove a plane</source>
        <translation>Ebene entfernen</translation>
    </message>
    <message>
        <source>crop</source>
        <translation>beschneiden</translation>
    </message>
    <message>
        <source>Remove table, head rest and clothes</source>
        <translation>Tisch, Kopfstütze und Kleidung entfernen</translation>
    </message>
    <message>
        <source>Shows the body of a CT scan alone</source>
        <translation>Zeigt nur den Körper einer CT-Aufnahme</translation>
    </message>
    <message>
        <source>remove the table</source>
        <translation>Tisch entfernen</translation>
    </message>
    <message>
        <source>show the table</source>
        <translation>Tisch zeigen</translation>
    </message>
    <message>
        <source>Choose Scissors or Keep inside above, then draw around the part to remove or to keep.</source>
        <translation>Wählen Sie oben Schere oder Inneres behalten, und umfahren Sie, was entfernt werden oder bleiben soll.</translation>
    </message>
    <message>
        <source>Remove face</source>
        <translation>Gesicht entfernen</translation>
    </message>
    <message>
        <source>Cuts the front of the head away in the 3D view, to %1 mm behind its smoothed surface. This is no anonymization: look at the image, ears and bones stay, and slices show the face.</source>
        <translation>Schneidet in der 3D-Ansicht die Vorderseite des Kopfes weg, bis %1 mm hinter seiner geglätteten Oberfläche. Das ist keine Anonymisierung: prüfen Sie das Bild, Ohren und Knochen bleiben, und Schichten zeigen das Gesicht.</translation>
    </message>
    <message>
        <source>remove the face</source>
        <translation>Gesicht entfernen</translation>
    </message>
    <message>
        <source>show the face</source>
        <translation>Gesicht zeigen</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Fußwärts</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopfwärts</translation>
    </message>
</context>
<context>
    <name>varimarch::ExportActions</name>
    <message>
        <source>Export an &amp;image…</source>
        <translation>&amp;Bild exportieren…</translation>
    </message>
    <message>
        <source>Send the i&amp;mage to an archive…</source>
        <translation>Bild an ein Archiv se&amp;nden…</translation>
    </message>
    <message>
        <source>Export a &amp;turntable…</source>
        <translation>&amp;Drehung exportieren…</translation>
    </message>
    <message>
        <source>&amp;Export the times…</source>
        <translation>Zeit&amp;punkte exportieren…</translation>
    </message>
    <message>
        <source>Export a re&amp;port…</source>
        <translation>Ber&amp;icht exportieren…</translation>
    </message>
    <message>
        <source>Export the &amp;cuts…</source>
        <translation>S&amp;chnitte exportieren…</translation>
    </message>
    <message>
        <source>Export a cha&amp;nge of the look from</source>
        <translation>&amp;Wechsel der Darstellung exportieren von</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cannot export</source>
        <translation>Export nicht möglich</translation>
    </message>
    <message>
        <source>Export a turntable</source>
        <translation>Drehung exportieren</translation>
    </message>
    <message>
        <source>Rendering the turntable</source>
        <translation>Eine Drehung wird gezeichnet</translation>
    </message>
    <message>
        <source>Export the times</source>
        <translation>Zeitpunkte exportieren</translation>
    </message>
    <message>
        <source>Rendering the times</source>
        <translation>Die Zeitpunkte werden berechnet</translation>
    </message>
    <message>
        <source>An added scan stays at the time before, since another could not be read: %1</source>
        <translation>Eine hinzugefügte Aufnahme bleibt beim vorherigen Zeitpunkt, weil ein anderer nicht gelesen werden konnte: %1</translation>
    </message>
    <message>
        <source>Export a report</source>
        <translation>Bericht exportieren</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Export the cuts</source>
        <translation>Schnitte exportieren</translation>
    </message>
    <message>
        <source>Rendering the cuts</source>
        <translation>Die Schnitte werden berechnet</translation>
    </message>
    <message>
        <source>Export a change of the look</source>
        <translation>Wechsel der Darstellung exportieren</translation>
    </message>
    <message>
        <source>Rendering the change</source>
        <translation>Der Wechsel wird berechnet</translation>
    </message>
    <message>
        <source>The current look cannot change: it is no composite, or has regions</source>
        <translation>Die jetzige Darstellung kann nicht wechseln: Sie ist keine Überlagerung oder hat Bereiche</translation>
    </message>
</context>
<context>
    <name>varimarch::ExportDialog</name>
    <message>
        <source>Transparent background (PNG)</source>
        <translation>Durchsichtiger Hintergrund (PNG)</translation>
    </message>
    <message>
        <source>Directions and measurements</source>
        <translation>Richtungen und Messungen</translation>
    </message>
    <message>
        <source>Export an image</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> Pixel</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>DICOM without data of the patient (*.dcm)</source>
        <translation>DICOM ohne Daten des Patienten (*.dcm)</translation>
    </message>
    <message>
        <source>Cannot export</source>
        <translation>Export nicht möglich</translation>
    </message>
</context>
<context>
    <name>varimarch::FusionBar</name>
    <message>
        <source>Checkerboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>Blend of the volumes</source>
        <translation>Mischung der Volumen</translation>
    </message>
    <message>
        <source>0 shows the first volume, 1 those over it</source>
        <translation>0 zeigt das erste Volumen, 1 die darüber</translation>
    </message>
    <message>
        <source>Shows the volumes in alternate squares of 20 mm</source>
        <translation>Zeigt die Volumen abwechselnd in Quadraten von 20 mm</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Mischung</translation>
    </message>
    <message>
        <source>blend of the volumes</source>
        <translation>Mischung der Volumen</translation>
    </message>
    <message>
        <source>checkerboard</source>
        <translation>Schachbrett</translation>
    </message>
</context>
<context>
    <name>varimarch::GradientOpacityBox</name>
    <message>
        <source>Opacity by gradient</source>
        <translation>Deckkraft nach Gradient</translation>
    </message>
    <message>
        <source>Makes edges between materials stand out from homogeneous regions</source>
        <translation>Hebt Grenzen zwischen Materialien aus Gleichförmigem hervor</translation>
    </message>
    <message>
        <source>switch off opacity by gradient</source>
        <translation>Deckkraft nach Gradient ausschalten</translation>
    </message>
    <message>
        <source>switch on opacity by gradient</source>
        <translation>Deckkraft nach Gradient einschalten</translation>
    </message>
    <message>
        <source>HU/mm</source>
        <translation>HE/mm</translation>
    </message>
    <message>
        <source>per mm</source>
        <translation>je mm</translation>
    </message>
</context>
<context>
    <name>varimarch::HelpActions</name>
    <message>
        <source>&lt;b&gt;Not for diagnostic use.&lt;/b&gt; This program is not a medical device. It must not be used to diagnose, to plan or to guide a treatment.</source>
        <translation>&lt;b&gt;Nicht für die Diagnose.&lt;/b&gt; Dieses Programm ist kein Medizinprodukt. Es darf nicht verwendet werden, um zu diagnostizieren oder eine Behandlung zu planen oder zu leiten.</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>Be&amp;fehl suchen…</translation>
    </message>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>&amp;Maus und Tasten</translation>
    </message>
    <message>
        <source>&amp;Two-minute tour</source>
        <translation>&amp;Rundgang in zwei Minuten</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Open the l&amp;og folder</source>
        <translation>Ordner des &amp;Protokolls öffnen</translation>
    </message>
    <message>
        <source>&amp;About Varimarch</source>
        <translation>Ü&amp;ber Varimarch</translation>
    </message>
    <message>
        <source>Varimarch</source>
        <translation>Varimarch</translation>
    </message>
    <message>
        <source>I understand</source>
        <translation>Ich habe verstanden</translation>
    </message>
    <message>
        <source>As on the &amp;desktop</source>
        <translation>Wie auf dem &amp;Schreibtisch</translation>
    </message>
    <message>
        <source>The program will use the desktop&apos;s language after a restart</source>
        <translation>Das Programm verwendet nach einem Neustart die Sprache des Schreibtischs</translation>
    </message>
    <message>
        <source>The program will use %1 after a restart</source>
        <translation>Das Programm verwendet nach einem Neustart %1</translation>
    </message>
    <message>
        <source>The volume</source>
        <translation>Das Volumen</translation>
    </message>
    <message>
        <source>Drag to turn it, drag with Shift or the middle button to move it, and turn the wheel to come nearer. A double-click shows it alone, another one all views again.</source>
        <translation>Ziehen dreht es, Ziehen mit Umschalt oder der mittleren Taste verschiebt es, und das Rad holt es näher. Ein Doppelklick zeigt es allein, ein weiterer wieder alle Ansichten.</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>The wheel goes through the slices. Drag the cross to move all three, its arms to tilt them, and drag with the right button for brightness and contrast. Number keys choose a usual window.</source>
        <translation>Das Rad blättert durch die Schnitte. Das Fadenkreuz zu ziehen bewegt alle drei, seine Arme kippen sie, und Ziehen mit der rechten Taste ändert Helligkeit und Kontrast. Zifferntasten wählen ein übliches Fenster.</translation>
    </message>
    <message>
        <source>Looks</source>
        <translation>Darstellungen</translation>
    </message>
    <message>
        <source>Each image is this scan with another look. Click one; Ctrl+Z takes it back, as it does every edit.</source>
        <translation>Jedes Bild ist diese Aufnahme in einer anderen Darstellung. Ein Klick wählt sie; Strg+Z nimmt sie zurück, wie jede Änderung.</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>The curve says how opaque each value is, over the histogram of the scan. Drag its points, click to add one, and double-click a point for its numbers.</source>
        <translation>Die Kurve sagt, wie undurchsichtig jeder Wert ist, über dem Histogramm der Aufnahme. Ihre Punkte lassen sich ziehen, ein Klick fügt einen hinzu, ein Doppelklick zeigt seine Zahlen.</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Remove the table with one click, drag a box or a plane in the volume, or cut with the scissors of the tool bar.</source>
        <translation>Den Tisch mit einem Klick entfernen, einen Quader oder eine Ebene im Volumen ziehen, oder mit der Schere der Werkzeugleiste schneiden.</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Choose a measurement in the tool bar and drag in a slice or in the volume. All of them are listed here and in reports.</source>
        <translation>Eine Messung in der Werkzeugleiste wählen und in einem Schnitt oder im Volumen ziehen. Alle stehen hier in einer Liste und in Berichten.</translation>
    </message>
    <message>
        <source>Everything else</source>
        <translation>Alles andere</translation>
    </message>
    <message>
        <source>Ctrl+K finds any command by a word, and F1 lists what the mouse and the keys do. The menu File saves sessions, images and reports.</source>
        <translation>Strg+K findet jeden Befehl durch ein Wort, und F1 zeigt, was Maus und Tasten tun. Das Menü Datei speichert Sitzungen, Bilder und Berichte.</translation>
    </message>
    <message>
        <source>About Varimarch</source>
        <translation>Über Varimarch</translation>
    </message>
    <message>
        <source>&lt;b&gt;Varimarch %1&lt;/b&gt;&lt;p&gt;Shows CT and MR volumes with a promised error.&lt;/p&gt;</source>
        <translation>&lt;b&gt;Varimarch %1&lt;/b&gt;&lt;p&gt;Zeigt CT- und MR-Volumen mit einem zugesagten Fehler.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>varimarch::KeyImagesBox</name>
    <message>
        <source>Key images</source>
        <translation>Schlüsselbilder</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Hingehen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Tools, Mark a key image adds the view that was clicked last. Reports show all of them.</source>
        <translation>Werkzeuge, Schlüsselbild merken fügt die zuletzt angeklickte Ansicht hinzu. Berichte zeigen alle.</translation>
    </message>
    <message>
        <source>mark a key image</source>
        <translation>Schlüsselbild merken</translation>
    </message>
    <message>
        <source>rename</source>
        <translation>umbenennen</translation>
    </message>
    <message>
        <source>go to a key image</source>
        <translation>zu einem Schlüsselbild gehen</translation>
    </message>
    <message>
        <source>remove a key image</source>
        <translation>Schlüsselbild entfernen</translation>
    </message>
</context>
<context>
    <name>varimarch::LightEffectsBox</name>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>scattering</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>The part of the light that matter scatters and surfaces do not reflect; 0 is off.</source>
        <translation>Der Teil des Lichts, den Materie streut und Oberflächen nicht zurückwerfen; 0 ist aus.</translation>
    </message>
    <message>
        <source>Scattered light mostly goes back below 0, and straight on above.</source>
        <translation>Unter 0 geht gestreutes Licht meist zurück, darüber geradeaus.</translation>
    </message>
    <message>
        <source>How far matter dims scattered light without shadows: 0 not at all, 1 everywhere.</source>
        <translation>Wie weit Materie ohne Schatten gestreutes Licht schwächt: 0 gar nicht, 1 überall.</translation>
    </message>
    <message>
        <source>Scattering</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Dimmed within</source>
        <translation>Geschwächt bis</translation>
    </message>
    <message>
        <source>Light that suits the look</source>
        <translation>Licht, das zur Darstellung passt</translation>
    </message>
    <message>
        <source>Replaces all of this by the light of the preset.</source>
        <translation>Ersetzt all dies durch das Licht der Vorgabe.</translation>
    </message>
    <message>
        <source>light of the preset</source>
        <translation>Licht der Vorgabe</translation>
    </message>
    <message>
        <source>How dark the shadows are that volumes cast on themselves and on each other, from lights that are not at the eye; 0 is off. An image takes about three times as long.</source>
        <translation>Wie dunkel die Schatten sind, die die Volumen auf sich selbst und aufeinander werfen, von Lichtern, die nicht am Auge sind; 0 ist aus. Ein Bild dauert etwa dreimal so lange.</translation>
    </message>
    <message>
        <source>shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>ambient occlusion</source>
        <translation>Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>How much darker places are that see little of what is around the volume; 0 is off.</source>
        <translation>Wie viel dunkler Stellen sind, die wenig von der Umgebung des Volumens sehen; 0 ist aus.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Matter farther away does not occlude. 0 stands for 16 voxels.</source>
        <translation>Weiter entfernte Materie verdeckt nicht. 0 steht für 16 Voxel.</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Verdeckung</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
</context>
<context>
    <name>varimarch::LightsPanel</name>
    <message>
        <source>At the eye</source>
        <translation>Am Auge</translation>
    </message>
    <message>
        <source>Turns with the camera</source>
        <translation>Dreht sich mit der Kamera</translation>
    </message>
    <message>
        <source>Direction in the patient</source>
        <translation>Richtung im Patienten</translation>
    </message>
    <message>
        <source>Point in the patient</source>
        <translation>Punkt im Patienten</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Lichter</translation>
    </message>
    <message>
        <source>Add a light</source>
        <translation>Licht hinzufügen</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>intensity of a light</source>
        <translation>Stärke eines Lichts</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>direction of a light</source>
        <translation>Richtung eines Lichts</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>Nach rechts</translation>
    </message>
    <message>
        <source>Upwards</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Left, back, head of the patient [mm]</source>
        <translation>Links, hinten, Kopf des Patienten [mm]</translation>
    </message>
    <message>
        <source>place of a light</source>
        <translation>Ort eines Lichts</translation>
    </message>
    <message>
        <source>Move to the crosshair of the slices</source>
        <translation>An das Fadenkreuz der Schichten setzen</translation>
    </message>
    <message>
        <source>Place [mm]</source>
        <translation>Ort [mm]</translation>
    </message>
    <message>
        <source>add a light</source>
        <translation>Licht hinzufügen</translation>
    </message>
    <message>
        <source>remove a light</source>
        <translation>Licht entfernen</translation>
    </message>
    <message>
        <source>colour of a light</source>
        <translation>Farbe eines Lichts</translation>
    </message>
    <message>
        <source>How soft its shadows are: half the angle of the cone that the light comes from.</source>
        <translation>Wie weich seine Schatten sind: der halbe Winkel des Kegels, aus dem das Licht kommt.</translation>
    </message>
    <message>
        <source>softness of a light</source>
        <translation>Weichheit eines Lichts</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>Place to the patient&apos;s left [mm]</source>
        <translation>Ort nach links am Patienten [mm]</translation>
    </message>
    <message>
        <source>Place to the back [mm]</source>
        <translation>Ort nach hinten [mm]</translation>
    </message>
    <message>
        <source>Place to the head [mm]</source>
        <translation>Ort zum Kopf [mm]</translation>
    </message>
</context>
<context>
    <name>varimarch::LoadController</name>
    <message>
        <source>There is not enough memory for this volume.</source>
        <translation>Für dieses Volumen reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>open a segmentation</source>
        <translation>Segmentierung öffnen</translation>
    </message>
    <message>
        <source>rectify slices</source>
        <translation>Schichten entzerren</translation>
    </message>
    <message>
        <source>show slices as scanned</source>
        <translation>Schichten wie aufgenommen</translation>
    </message>
    <message>
        <source>At most %1 scans are drawn at once: remove one of them, and add the scan again</source>
        <translation>Höchstens %1 Aufnahmen werden zugleich gezeichnet: Entfernen Sie eine davon, und fügen Sie die Aufnahme erneut hinzu</translation>
    </message>
    <message>
        <source>add a scan</source>
        <translation>Aufnahme hinzufügen</translation>
    </message>
</context>
<context>
    <name>varimarch::LookPanel</name>
    <message>
        <source>Preset</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>choose %1</source>
        <translation>%1 wählen</translation>
    </message>
    <message>
        <source>HU</source>
        <translation>HE</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>%1, edited</source>
        <translation>%1, bearbeitet</translation>
    </message>
    <message>
        <source>custom look</source>
        <translation>eigene Darstellung</translation>
    </message>
    <message>
        <source>Load a look</source>
        <translation>Darstellung laden</translation>
    </message>
    <message numerus="yes">
        <source>The file holds %n looks:</source>
        <translation>
            <numerusform>Die Datei enthält %n Darstellung:</numerusform>
            <numerusform>Die Datei enthält %n Darstellungen:</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the look</source>
        <translation>Darstellung speichern</translation>
    </message>
    <message>
        <source>load %1</source>
        <translation>%1 laden</translation>
    </message>
    <message>
        <source>All looks (%1)</source>
        <translation>Alle Darstellungen (%1)</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Colour maps for any kind of colour vision; the opacity curve stays as it is</source>
        <translation>Farbtabellen für jedes Farbensehen; die Deckkraft bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>colour map %1</source>
        <translation>Farbtabelle %1</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden…</translation>
    </message>
    <message>
        <source>Loads a look from a file</source>
        <translation>Lädt eine Darstellung aus einer Datei</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Saves the look in a file</source>
        <translation>Speichert die Darstellung in einer Datei</translation>
    </message>
    <message>
        <source>The histogram is of %1 of %2 times</source>
        <translation>Das Histogramm zählt %1 von %2 Zeitpunkten</translation>
    </message>
</context>
<context>
    <name>varimarch::MainWindow</name>
    <message>
        <source>Varimarch, not for diagnostic use</source>
        <translation>Varimarch, nicht für die Diagnose</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>B&amp;eenden</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Suggested look</source>
        <translation>&amp;Vorgeschlagene Darstellung</translation>
    </message>
    <message>
        <source>suggested look</source>
        <translation>vorgeschlagene Darstellung</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Open a scan, or drop one here</source>
        <translation>Aufnahme öffnen oder hier ablegen</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Graphics card</source>
        <translation>Grafikkarte</translation>
    </message>
    <message>
        <source>The graphics card was reset, and the image is drawn anew; nothing is lost.</source>
        <translation>Die Grafikkarte wurde zurückgesetzt, und das Bild wird neu gezeichnet; nichts ist verloren.</translation>
    </message>
    <message>
        <source>The graphics card was reset again before it had drawn an image; save the session and start the program again, with another driver, or with LIBGL_ALWAYS_SOFTWARE=1 to draw without the card.</source>
        <translation>Die Grafikkarte wurde erneut zurückgesetzt, bevor sie ein Bild gezeichnet hatte; speichern Sie die Sitzung und starten Sie das Programm neu, mit einem anderen Treiber, oder mit LIBGL_ALWAYS_SOFTWARE=1, um ohne die Karte zu zeichnen.</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Anordnung zurücksetzen</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Lichter</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Registered; compare the volumes in the slices before you trust it</source>
        <translation>Registriert; vergleichen Sie die Volumen in den Schichten, bevor Sie sich darauf verlassen</translation>
    </message>
    <message>
        <source>Axial slice</source>
        <translation>Axiale Schicht</translation>
    </message>
    <message>
        <source>Coronal slice</source>
        <translation>Koronale Schicht</translation>
    </message>
    <message>
        <source>Sagittal slice</source>
        <translation>Sagittale Schicht</translation>
    </message>
    <message>
        <source>Along the curve</source>
        <translation>Entlang der Kurve</translation>
    </message>
    <message>
        <source>Titles of panels</source>
        <translation>Titel der Bedienfelder</translation>
    </message>
</context>
<context>
    <name>varimarch::MeasuresPanel</name>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Alle entfernen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>rename</source>
        <translation>umbenennen</translation>
    </message>
    <message>
        <source>remove a measurement</source>
        <translation>Messung entfernen</translation>
    </message>
    <message>
        <source>remove all measurements</source>
        <translation>alle Messungen entfernen</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Hingehen</translation>
    </message>
    <message>
        <source>Choose a measurement above, then drag in the volume or in a slice. Points can be dragged later. Double-click a name to change it, or a value to go there.</source>
        <translation>Wählen Sie oben eine Messung und ziehen Sie dann im Volumen oder in einer Schicht. Punkte können später verschoben werden. Ein Doppelklick auf einen Namen ändert ihn, einer auf einen Wert führt dorthin.</translation>
    </message>
    <message>
        <source>%1; the box shows or hides it</source>
        <translation>%1; das Kästchen zeigt oder verbirgt sie</translation>
    </message>
    <message>
        <source>show a measurement</source>
        <translation>Messung zeigen</translation>
    </message>
    <message>
        <source>hide a measurement</source>
        <translation>Messung verbergen</translation>
    </message>
    <message>
        <source>go to a measurement</source>
        <translation>zu einer Messung gehen</translation>
    </message>
    <message>
        <source>Save the measurements</source>
        <translation>Messungen speichern</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Cannot save</source>
        <translation>Speichern nicht möglich</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>DICOM structured report (*.dcm)</source>
        <translation>Strukturierter DICOM-Bericht (*.dcm)</translation>
    </message>
</context>
<context>
    <name>varimarch::NodePopover</name>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Midpoint</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Position where the curve is halfway to the next point</source>
        <translation>Stelle, an der die Kurve auf halbem Weg zum nächsten Punkt ist</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Schärfe</translation>
    </message>
    <message>
        <source>0 is a straight line to the next point, 1 is a step</source>
        <translation>0 ist eine Gerade zum nächsten Punkt, 1 eine Stufe</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
</context>
<context>
    <name>varimarch::OpenActions</name>
    <message>
        <source>Volumes (%1)</source>
        <translation>Volumen (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Loading %1</source>
        <translation>%1 wird geladen</translation>
    </message>
    <message>
        <source>A coarse copy is shown until the volume has been read for the first time</source>
        <translation>Eine grobe Kopie ist zu sehen, bis das Volumen zum ersten Mal gelesen ist</translation>
    </message>
    <message>
        <source>Loading was cancelled</source>
        <translation>Das Laden wurde abgebrochen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a &amp;folder…</source>
        <translation>&amp;Ordner öffnen…</translation>
    </message>
    <message>
        <source>Open a ra&amp;w file…</source>
        <translation>&amp;Rohdatei öffnen…</translation>
    </message>
    <message>
        <source>Open fi&amp;les as times…</source>
        <translation>Dateien als Zeitpun&amp;kte öffnen…</translation>
    </message>
    <message>
        <source>&amp;Kinds of volume in the series</source>
        <translation>Arten von Volumen in der Serie</translation>
    </message>
    <message>
        <source>A&amp;dd a scan…</source>
        <translation>Aufnahme hin&amp;zufügen…</translation>
    </message>
    <message>
        <source>Open a se&amp;gmentation…</source>
        <translation>Se&amp;gmentierung öffnen…</translation>
    </message>
    <message>
        <source>&amp;Ask for a scan at start</source>
        <translation>Beim Start nach einer &amp;Aufnahme fragen</translation>
    </message>
    <message>
        <source>Memor&amp;y for volumes</source>
        <translation>Arbeitsspeicher für &amp;Volumen</translation>
    </message>
    <message>
        <source>&amp;All of the computer&apos;s</source>
        <translation>&amp;Aller dieses Rechners</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>The next volume is read within this memory</source>
        <translation>Das nächste Volumen wird innerhalb dieses Speichers gelesen</translation>
    </message>
    <message>
        <source>There is no file to open: its name is empty.</source>
        <translation>Es gibt keine Datei zu öffnen: Ihr Name ist leer.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not answer: its disk or the network may be gone. Try again later.</source>
        <translation>„%1“ antwortet nicht: Der Datenträger oder das Netz ist vielleicht weg. Versuchen Sie es später noch einmal.</translation>
    </message>
    <message>
        <source>Varimarch</source>
        <translation>Varimarch</translation>
    </message>
    <message>
        <source>The program ended unexpectedly last time. Restore your session?</source>
        <translation>Das Programm wurde zuletzt unerwartet beendet. Die Sitzung wiederherstellen?</translation>
    </message>
    <message>
        <source>Open a volume</source>
        <translation>Volumen öffnen</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files</source>
        <translation>Ordner mit DICOM-Dateien öffnen</translation>
    </message>
    <message>
        <source>Open files as times: choose one of the files whose names differ in a number</source>
        <translation>Dateien als Zeitpunkte öffnen: eine der Dateien wählen, deren Namen sich in einer Zahl unterscheiden</translation>
    </message>
    <message>
        <source>Open a raw file</source>
        <translation>Rohdatei öffnen</translation>
    </message>
    <message>
        <source>Add a scan</source>
        <translation>Aufnahme hinzufügen</translation>
    </message>
    <message>
        <source>Where is the scan to draw over the one that is shown?</source>
        <translation>Wo liegt die Aufnahme, die über die gezeigte gezeichnet werden soll?</translation>
    </message>
    <message>
        <source>In a file…</source>
        <translation>In einer Datei…</translation>
    </message>
    <message>
        <source>In a folder of DICOM files…</source>
        <translation>In einem Ordner mit DICOM-Dateien…</translation>
    </message>
    <message>
        <source>Open a segmentation of this scan</source>
        <translation>Segmentierung dieser Aufnahme öffnen</translation>
    </message>
    <message>
        <source>This file may be a segmentation of the scan that is shown: it lies in the same place, and has %1 different whole values. Show it as segments of the scan?</source>
        <translation>Diese Datei kann eine Segmentierung der gezeigten Aufnahme sein: sie liegt am selben Ort und hat %1 verschiedene ganze Werte. Als Segmente der Aufnahme zeigen?</translation>
    </message>
    <message>
        <source>Show as segments</source>
        <translation>Als Segmente zeigen</translation>
    </message>
    <message>
        <source>Open as a scan</source>
        <translation>Als Aufnahme öffnen</translation>
    </message>
    <message>
        <source>Beside the scan the folder holds a segmentation. Show its segments?</source>
        <translation>Neben der Aufnahme enthält der Ordner eine Segmentierung. Ihre Segmente zeigen?</translation>
    </message>
    <message>
        <source>Look &quot;%1&quot;: %2. Press R to restore it.</source>
        <translation>Darstellung „%1“: %2. R stellt sie wieder her.</translation>
    </message>
    <message>
        <source>Added %1; the look panels now change it</source>
        <translation>%1 hinzugefügt; die Felder für das Aussehen ändern jetzt dieses Volumen</translation>
    </message>
    <message>
        <source>The two scans have different frames of reference: they may not fit on each other. Check their place in the slices, and move or register the added one.</source>
        <translation>Die beiden Aufnahmen haben verschiedene Bezugssysteme: sie passen vielleicht nicht aufeinander. Prüfen Sie ihre Lage in den Schichten, und verschieben oder registrieren Sie die hinzugefügte.</translation>
    </message>
    <message>
        <source>The files do not say whether the two scans are in the same space. They are placed by their coordinates: check that in the slices, and move or register the added one.</source>
        <translation>Die Dateien sagen nicht, ob die beiden Aufnahmen im selben Raum liegen. Sie liegen nach ihren Koordinaten: prüfen Sie das in den Schichten, und verschieben oder registrieren Sie die hinzugefügte.</translation>
    </message>
    <message>
        <source>Segments: %1</source>
        <translation>Segmente: %1</translation>
    </message>
    <message>
        <source>Cannot open</source>
        <translation>Öffnen nicht möglich</translation>
    </message>
</context>
<context>
    <name>varimarch::PresetGallery</name>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Add this look</source>
        <translation>Diese Darstellung aufnehmen</translation>
    </message>
    <message>
        <source>Adds the current look to this list</source>
        <translation>Nimmt die jetzige Darstellung in diese Liste auf</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes one of your own looks from this list</source>
        <translation>Nimmt eine eigene Darstellung aus dieser Liste</translation>
    </message>
    <message>
        <source>Your own look: F2 renames it, Delete removes it</source>
        <translation>Eigene: F2 benennt sie um, Entf entfernt sie</translation>
    </message>
    <message>
        <source>choose %1</source>
        <translation>%1 wählen</translation>
    </message>
    <message>
        <source>Remove a preset</source>
        <translation>Vorlage entfernen</translation>
    </message>
    <message>
        <source>Remove the preset %1? This cannot be undone.</source>
        <translation>Die Vorlage %1 entfernen? Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>For other kinds of scans (%1)</source>
        <translation>Für andere Aufnahmen (%1)</translation>
    </message>
</context>
<context>
    <name>varimarch::QualityPanel</name>
    <message>
        <source>Largest error</source>
        <translation>Größter Fehler</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Error at most</source>
        <translation>Fehler höchstens</translation>
    </message>
    <message>
        <source>quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>1/%1 of full brightness</source>
        <translation>1/%1 der vollen Helligkeit</translation>
    </message>
    <message>
        <source>Promise the error</source>
        <translation>Fehler versprechen</translation>
    </message>
    <message>
        <source>Otherwise all steps are as long as the spacing of the voxels suggests</source>
        <translation>Sonst sind alle Schritte so lang, wie der Abstand der Voxel es nahelegt</translation>
    </message>
    <message>
        <source>promise of the error</source>
        <translation>Versprechen des Fehlers</translation>
    </message>
    <message>
        <source>A ray ends where less than this part of the light behind it is left</source>
        <translation>Ein Strahl endet, wo weniger als dieser Teil des Lichts hinter ihm übrig ist</translation>
    </message>
    <message>
        <source>end of rays</source>
        <translation>Ende der Strahlen</translation>
    </message>
    <message>
        <source>Rays end at</source>
        <translation>Strahlen enden bei</translation>
    </message>
    <message>
        <source>None: voxels are boxes</source>
        <translation>Keine: Voxel sind Quader</translation>
    </message>
    <message>
        <source>The values as they were measured</source>
        <translation>Die Werte, wie sie gemessen wurden</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>The fastest</source>
        <translation>Am schnellsten</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>Kubisch</translation>
    </message>
    <message>
        <source>A spline: edges have no staircases</source>
        <translation>Ein Spline: Kanten haben keine Treppen</translation>
    </message>
    <message>
        <source>interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Zufälliger Beginn</translation>
    </message>
    <message>
        <source>Turns the rings that long steps leave into fine grain</source>
        <translation>Macht aus den Ringen langer Schritte ein feines Korn</translation>
    </message>
    <message>
        <source>jitter</source>
        <translation>zufälliger Beginn</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>not promised</source>
        <translation>nicht versprochen</translation>
    </message>
    <message>
        <source>Read only what the image needs</source>
        <translation>Nur lesen, was das Bild braucht</translation>
    </message>
    <message>
        <source>Coarse voxels stay where they change the image by less than half of the error</source>
        <translation>Grobe Voxel bleiben, wo sie das Bild um weniger als den halben Fehler verändern</translation>
    </message>
    <message>
        <source>what is read</source>
        <translation>was gelesen wird</translation>
    </message>
</context>
<context>
    <name>varimarch::RawForm</name>
    <message>
        <source>Layout of %1</source>
        <translation>Aufbau von %1</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>little-endian</source>
        <translation>little-endian (kleines Ende zuerst)</translation>
    </message>
    <message>
        <source>big-endian</source>
        <translation>big-endian (großes Ende zuerst)</translation>
    </message>
    <message>
        <source>Bytes before the first voxel</source>
        <translation>Bytes vor dem ersten Voxel</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>Bytefolge</translation>
    </message>
    <message>
        <source>Header bytes</source>
        <translation>Bytes des Kopfs</translation>
    </message>
    <message>
        <source>Spacing [mm]</source>
        <translation>Abstand [mm]</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>Skip them as a header</source>
        <translation>Als Kopf überspringen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>The file is compressed, so its size can only be checked when it is read.</source>
        <translation>Die Datei ist gepackt; ihre Größe lässt sich erst beim Lesen prüfen.</translation>
    </message>
    <message>
        <source>The layout fits: the file has the %1 bytes that it needs.</source>
        <translation>Es passt: Die Datei hat die %1 Bytes, die das braucht.</translation>
    </message>
    <message>
        <source>The file has %1 bytes more than this layout needs.</source>
        <translation>Die Datei hat %1 Bytes mehr, als das braucht.</translation>
    </message>
    <message>
        <source>The layout does not fit: the file has %1 bytes less than it needs.</source>
        <translation>Es passt nicht: Die Datei hat %1 Bytes weniger, als das braucht.</translation>
    </message>
    <message>
        <source>The file ends before this slice</source>
        <translation>Die Datei endet vor dieser Schicht</translation>
    </message>
    <message>
        <source>Distance of columns [mm]</source>
        <translation>Abstand der Spalten [mm]</translation>
    </message>
    <message>
        <source>Distance of rows [mm]</source>
        <translation>Abstand der Zeilen [mm]</translation>
    </message>
    <message>
        <source>Distance of slices [mm]</source>
        <translation>Abstand der Schichten [mm]</translation>
    </message>
</context>
<context>
    <name>varimarch::RegionEditor</name>
    <message>
        <source>Add a rectangle</source>
        <translation>Rechteck hinzufügen</translation>
    </message>
    <message>
        <source>+ Rectangle</source>
        <translation>+ Rechteck</translation>
    </message>
    <message>
        <source>Add an ellipse</source>
        <translation>Ellipse hinzufügen</translation>
    </message>
    <message>
        <source>+ Ellipse</source>
        <translation>+ Ellipse</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Show all values and gradients</source>
        <translation>Alle Werte und Gradienten zeigen</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>add a region</source>
        <translation>Bereich hinzufügen</translation>
    </message>
    <message>
        <source>delete a region</source>
        <translation>Bereich löschen</translation>
    </message>
    <message>
        <source>colour of a region</source>
        <translation>Farbe eines Bereichs</translation>
    </message>
    <message>
        <source>resize a region</source>
        <translation>Größe eines Bereichs ändern</translation>
    </message>
    <message>
        <source>move a region</source>
        <translation>Bereich verschieben</translation>
    </message>
    <message>
        <source>Add a rectangle here</source>
        <translation>Hier ein Rechteck hinzufügen</translation>
    </message>
    <message>
        <source>Add an ellipse here</source>
        <translation>Hier eine Ellipse hinzufügen</translation>
    </message>
    <message>
        <source>Regions of value and gradient</source>
        <translation>Bereiche von Wert und Gradient</translation>
    </message>
    <message>
        <source>%1 %2, gradient %3 per mm: %4 voxels</source>
        <translation>%1 %2, Gradient %3 je mm: %4 Voxel</translation>
    </message>
</context>
<context>
    <name>varimarch::RegionsBox</name>
    <message>
        <source>Regions of value and gradient</source>
        <translation>Bereiche von Wert und Gradient</translation>
    </message>
    <message>
        <source>Rectangles and ellipses over the values and their gradients, instead of the curves</source>
        <translation>Rechtecke und Ellipsen über den Werten und ihren Gradienten, statt der Kurven</translation>
    </message>
    <message>
        <source>opacity of a region</source>
        <translation>Deckkraft eines Bereichs</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>soft edge of a region</source>
        <translation>weicher Rand eines Bereichs</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Weicher Rand</translation>
    </message>
    <message>
        <source>switch off regions</source>
        <translation>Bereiche ausschalten</translation>
    </message>
    <message>
        <source>switch on regions</source>
        <translation>Bereiche einschalten</translation>
    </message>
    <message>
        <source>HU</source>
        <translation>HE</translation>
    </message>
</context>
<context>
    <name>varimarch::RemoteControl</name>
    <message>
        <source>look of a script</source>
        <translation>Darstellung eines Skripts</translation>
    </message>
</context>
<context>
    <name>varimarch::SaveActions</name>
    <message>
        <source>&amp;Save the session…</source>
        <translation>Sitzung &amp;speichern…</translation>
    </message>
    <message>
        <source>Varimarch</source>
        <translation>Varimarch</translation>
    </message>
    <message>
        <source>Your measurements, cuts, look and segments are not saved. Save the session?</source>
        <translation>Ihre Messungen, Schnitte, Darstellung und Segmente sind nicht gespeichert. Sitzung speichern?</translation>
    </message>
    <message>
        <source>Cannot save</source>
        <translation>Speichern nicht möglich</translation>
    </message>
    <message>
        <source>This scan was fetched from an archive and is deleted at the end, so a session could not find it again. Fetch it with &quot;Keep in…&quot; first.</source>
        <translation>Diese Aufnahme stammt aus einem Archiv und wird am Ende gelöscht; eine Sitzung fände sie nicht wieder. Holen Sie sie zuerst mit „Behalten in…“.</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>Sessions (*.json)</source>
        <translation>Sitzungen (*.json)</translation>
    </message>
    <message>
        <source>Segmentation of 3D Slicer (*.seg.nrrd)</source>
        <translation>Segmentierung von 3D Slicer (*.seg.nrrd)</translation>
    </message>
    <message>
        <source>NIfTI (*.nii.gz)</source>
        <translation>NIfTI (*.nii.gz)</translation>
    </message>
    <message>
        <source>DICOM segmentation (*.dcm)</source>
        <translation>DICOM-Segmentierung (*.dcm)</translation>
    </message>
    <message>
        <source>Save the segmentation</source>
        <translation>Segmentierung speichern</translation>
    </message>
    <message>
        <source>save the segmentation</source>
        <translation>Segmentierung speichern</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
</context>
<context>
    <name>varimarch::ScanLists</name>
    <message>
        <source>&amp;Recent scans</source>
        <translation>&amp;Letzte Aufnahmen</translation>
    </message>
    <message>
        <source>Clear the list</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>St&amp;udy list…</source>
        <translation>St&amp;udienliste…</translation>
    </message>
    <message>
        <source>Arc&amp;hive (PACS)…</source>
        <translation>Arc&amp;hiv (PACS)…</translation>
    </message>
    <message>
        <source>DICOM attri&amp;butes…</source>
        <translation>DICOM-A&amp;ttribute…</translation>
    </message>
</context>
<context>
    <name>varimarch::SegmentEditingBox</name>
    <message>
        <source>Draw segments</source>
        <translation>Segmente zeichnen</translation>
    </message>
    <message>
        <source>New segment</source>
        <translation>Neues Segment</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>Segment %1</translation>
    </message>
    <message>
        <source>new segment</source>
        <translation>neues Segment</translation>
    </message>
    <message>
        <source>Nothing has changed: the value there is outside the range, or no voxels are left.</source>
        <translation>Nichts hat sich geändert: der Wert dort liegt außerhalb des Bereichs, oder es bleiben keine Voxel.</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Click in a slice or in the volume: the connected voxels of these values are added.</source>
        <translation>In eine Schicht oder ins Volumen klicken: die zusammenhängenden Voxel mit diesen Werten kommen hinzu.</translation>
    </message>
    <message>
        <source>Drag in a slice to paint.</source>
        <translation>In einer Schicht ziehen, um zu malen.</translation>
    </message>
    <message>
        <source>Drag in a slice to erase.</source>
        <translation>In einer Schicht ziehen, um zu radieren.</translation>
    </message>
    <message>
        <source>Smallest value of a region</source>
        <translation>Kleinster Wert eines Bereichs</translation>
    </message>
    <message>
        <source>Largest value of a region</source>
        <translation>Größter Wert eines Bereichs</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Radius des Pinsels</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Keep the largest part</source>
        <translation>Größten Teil behalten</translation>
    </message>
    <message>
        <source>Remove parts below</source>
        <translation>Teile entfernen unter</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Save the segmentation…</source>
        <translation>Segmentierung speichern…</translation>
    </message>
    <message>
        <source>Volume of the smallest part that is kept</source>
        <translation>Volumen des kleinsten Teils, der bleibt</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> ml</translation>
    </message>
    <message>
        <source>Width of the smoothing</source>
        <translation>Breite der Glättung</translation>
    </message>
    <message>
        <source>Working on the segment</source>
        <translation>Das Segment wird bearbeitet</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>varimarch::SegmentEditor</name>
    <message>
        <source>add a region</source>
        <translation>Bereich hinzufügen</translation>
    </message>
    <message>
        <source>erase</source>
        <translation>radieren</translation>
    </message>
    <message>
        <source>paint</source>
        <translation>malen</translation>
    </message>
    <message>
        <source>keep the largest part</source>
        <translation>größten Teil behalten</translation>
    </message>
    <message>
        <source>remove small parts</source>
        <translation>kleine Teile entfernen</translation>
    </message>
    <message>
        <source>smooth a segment</source>
        <translation>Segment glätten</translation>
    </message>
    <message>
        <source>The segments were changed meanwhile, so this edit was left out.</source>
        <translation>Die Segmente wurden inzwischen geändert, daher wurde diese Änderung ausgelassen.</translation>
    </message>
</context>
<context>
    <name>varimarch::SegmentsPanel</name>
    <message>
        <source>A segmentation of this scan colours its regions: a DICOM segmentation, a segmentation of 3D Slicer, or a label map in NRRD, NIfTI or another format.</source>
        <translation>Eine Segmentierung dieser Aufnahme färbt ihre Bereiche: eine DICOM-Segmentierung, eine Segmentierung von 3D Slicer oder ein Label-Volumen in NRRD, NIfTI oder einem anderen Format.</translation>
    </message>
    <message>
        <source>Open a segmentation…</source>
        <translation>Segmentierung öffnen…</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>Hide all</source>
        <translation>Alle verbergen</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Opacity of the selected segments</source>
        <translation>Deckkraft der ausgewählten Segmente</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern…</translation>
    </message>
    <message>
        <source>Close the segmentation</source>
        <translation>Segmentierung schließen</translation>
    </message>
    <message>
        <source>close the segmentation</source>
        <translation>Segmentierung schließen</translation>
    </message>
    <message>
        <source>HU</source>
        <translation>HE</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>Volume
ml</source>
        <translation>Volumen
ml</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>The volume cannot show segments, since its voxels have several values.</source>
        <translation>Das Volumen kann keine Segmente zeigen, da seine Voxel mehrere Werte haben.</translation>
    </message>
    <message>
        <source>rename</source>
        <translation>umbenennen</translation>
    </message>
    <message>
        <source>show a segment</source>
        <translation>Segment zeigen</translation>
    </message>
    <message>
        <source>hide a segment</source>
        <translation>Segment verbergen</translation>
    </message>
    <message>
        <source>show all segments</source>
        <translation>alle Segmente zeigen</translation>
    </message>
    <message>
        <source>hide all segments</source>
        <translation>alle Segmente verbergen</translation>
    </message>
    <message>
        <source>opacity of segments</source>
        <translation>Deckkraft von Segmenten</translation>
    </message>
    <message>
        <source>colour of a segment</source>
        <translation>Farbe eines Segments</translation>
    </message>
    <message>
        <source>Save the statistics</source>
        <translation>Statistik speichern</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Cannot save</source>
        <translation>Speichern nicht möglich</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>The volume shows segments only with the blend mode Composite.</source>
        <translation>Das Volumen zeigt Segmente nur mit der Mischung „Überlagerung“.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>Segments of %1</source>
        <translation>Segmente von %1</translation>
    </message>
    <message>
        <source>The volume shows at most %1 scans and segmentations together; not all fit.</source>
        <translation>Das Volumen zeigt höchstens %1 Aufnahmen und Segmentierungen zusammen; nicht alle passen hinein.</translation>
    </message>
</context>
<context>
    <name>varimarch::SendDialog</name>
    <message>
        <source>Directions and measurements</source>
        <translation>Richtungen und Messungen</translation>
    </message>
    <message>
        <source>With the patient and the study of the scan</source>
        <translation>Mit Patient und Studie der Aufnahme</translation>
    </message>
    <message>
        <source>Send the image to an archive</source>
        <translation>Bild an ein Archiv senden</translation>
    </message>
    <message>
        <source>Otherwise the image names nobody, and the archive lists it as a study of its own. With several scans it is the one chosen in the panel Volumes.</source>
        <translation>Sonst nennt das Bild niemanden, und das Archiv führt es als eigene Studie. Bei mehreren Aufnahmen ist es die unter „Volumen“ gewählte.</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>Add an archive first.</source>
        <translation>Fügen Sie zuerst ein Archiv hinzu.</translation>
    </message>
    <message>
        <source>The archive has stored the image.</source>
        <translation>Das Archiv hat das Bild gespeichert.</translation>
    </message>
    <message>
        <source>Sending…</source>
        <translation>Senden…</translation>
    </message>
    <message>
        <source>The measurements too, as a structured report</source>
        <translation>Auch die Messungen, als strukturierter Bericht</translation>
    </message>
</context>
<context>
    <name>varimarch::SeriesPicker</name>
    <message>
        <source>%1
%2, images: %3</source>
        <translation>%1
%2, Bilder: %3</translation>
    </message>
    <message>
        <source>No description</source>
        <translation>Ohne Beschreibung</translation>
    </message>
    <message>
        <source>Choose a series</source>
        <translation>Serie wählen</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serien</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Found %1 series.</source>
        <translation>%1 Serien gefunden.</translation>
    </message>
</context>
<context>
    <name>varimarch::ShadingBox</name>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>Clinical</source>
        <translation>Klinisch</translation>
    </message>
    <message>
        <source>Glossy</source>
        <translation>Glänzend</translation>
    </message>
    <message>
        <source>Flat: unshaded colours</source>
        <translation>Flach: Farben ohne Schattierung</translation>
    </message>
    <message>
        <source>Light and shading</source>
        <translation>Licht und Schattierung</translation>
    </message>
    <message>
        <source>shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation>Diffus</translation>
    </message>
    <message>
        <source>Specular</source>
        <translation>Glanz</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Schärfe des Glanzes</translation>
    </message>
    <message>
        <source>light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene Werte</translation>
    </message>
    <message>
        <source>Gradient below which light other than ambient weakens, so that noise in homogeneous material does not glitter</source>
        <translation>Gradient, unterhalb dessen das nicht umgebende Licht schwächer wird, damit Rauschen in gleichmäßigem Material nicht glitzert</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source> HU/mm</source>
        <translation> HE/mm</translation>
    </message>
    <message>
        <source> per mm</source>
        <translation> je mm</translation>
    </message>
</context>
<context>
    <name>varimarch::SlabBar</name>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Blend mode of the slab</source>
        <translation>Mischung der dicken Schicht</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Thickness of the slices</source>
        <translation>Dicke der Schichten</translation>
    </message>
    <message>
        <source>A slab shows the largest, the smallest or the mean value over its thickness</source>
        <translation>Dicke Schichten zeigen den größten, kleinsten oder mittleren Wert darin</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>slab</source>
        <translation>Dicke der Schicht</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Gerade richten</translation>
    </message>
    <message>
        <source>Show axial, coronal and sagittal slices again</source>
        <translation>Wieder axiale, koronale und sagittale Schichten zeigen</translation>
    </message>
    <message>
        <source>straighten the slices</source>
        <translation>Schichten gerade richten</translation>
    </message>
</context>
<context>
    <name>varimarch::SliceView</name>
    <message>
        <source>window and level</source>
        <translation>Fenster und Mitte</translation>
    </message>
    <message>
        <source>move the crosshair</source>
        <translation>Fadenkreuz bewegen</translation>
    </message>
    <message>
        <source>turn the slices</source>
        <translation>Schichten drehen</translation>
    </message>
</context>
<context>
    <name>varimarch::StartPage</name>
    <message>
        <source>Open a scan, or drop one on this window</source>
        <translation>Öffnen Sie eine Aufnahme, oder ziehen Sie eine hierher</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Datei öffnen…</translation>
    </message>
    <message>
        <source>NIfTI, NRRD, MetaImage, a ZIP of a CD, a session …</source>
        <translation>NIfTI, NRRD, MetaImage, ZIP einer CD, eine Sitzung …</translation>
    </message>
    <message>
        <source>Open a folder…</source>
        <translation>Ordner öffnen…</translation>
    </message>
    <message>
        <source>A CD, or the slices of a DICOM series</source>
        <translation>Eine CD oder die Schichten einer DICOM-Serie</translation>
    </message>
    <message>
        <source>Recent scans</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Head CT</source>
        <translation>CT eines Kopfes</translation>
    </message>
    <message>
        <source>From the package invesalius-examples</source>
        <translation>Aus dem Paket invesalius-examples</translation>
    </message>
    <message>
        <source>Phantom of a torso</source>
        <translation>Phantom eines Rumpfes</translation>
    </message>
    <message>
        <source>Computed, with bones, lungs and vessels</source>
        <translation>Berechnet, mit Knochen, Lunge und Gefäßen</translation>
    </message>
    <message>
        <source>Two-minute tour</source>
        <translation>Rundgang in zwei Minuten</translation>
    </message>
    <message>
        <source>What is where, on the phantom</source>
        <translation>Was wo ist, am Phantom gezeigt</translation>
    </message>
</context>
<context>
    <name>varimarch::StudyListWindow</name>
    <message>
        <source>No name</source>
        <translation>Kein Name</translation>
    </message>
    <message>
        <source>Study without description</source>
        <translation>Studie ohne Beschreibung</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Study list</source>
        <translation>Studienliste</translation>
    </message>
    <message>
        <source>Search for names, numbers, dates and descriptions</source>
        <translation>Nach Namen, Nummern, Daten und Beschreibungen suchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Patient, study, series</source>
        <translation>Patient, Studie, Serie</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Add a folder…</source>
        <translation>Ordner hinzufügen…</translation>
    </message>
    <message>
        <source>Find changes</source>
        <translation>Änderungen suchen</translation>
    </message>
    <message>
        <source>Reads files of the folders that are new or have changed</source>
        <translation>Liest neue und geänderte Dateien der Ordner</translation>
    </message>
    <message>
        <source>Remove a folder</source>
        <translation>Ordner entfernen</translation>
    </message>
    <message>
        <source>Remove the whole list</source>
        <translation>Ganze Liste entfernen</translation>
    </message>
    <message>
        <source>Deletes all that the list knows of patients; scans stay</source>
        <translation>Löscht alles, was die Liste über Patienten weiß; Aufnahmen bleiben</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Reading the folders…</source>
        <translation>Ordner werden gelesen…</translation>
    </message>
    <message>
        <source>Add a folder with DICOM files. The list stays on this computer and is yours only.</source>
        <translation>Fügen Sie einen Ordner mit DICOM-Dateien hinzu. Die Liste bleibt auf diesem Rechner und gehört nur Ihnen.</translation>
    </message>
    <message>
        <source>Series: %1. A double-click opens one.</source>
        <translation>Serien: %1. Ein Doppelklick öffnet eine.</translation>
    </message>
    <message>
        <source>Add a folder</source>
        <translation>Ordner hinzufügen</translation>
    </message>
    <message>
        <source>Delete all that the list knows of folders and patients? The scans themselves stay.</source>
        <translation>Alles löschen, was die Liste über Ordner und Patienten weiß? Die Aufnahmen selbst bleiben.</translation>
    </message>
</context>
<context>
    <name>varimarch::TagsWindow</name>
    <message>
        <source>Reading the attributes…</source>
        <translation>Attribute werden gelesen…</translation>
    </message>
    <message>
        <source>DICOM attributes</source>
        <translation>DICOM-Attribute</translation>
    </message>
    <message>
        <source>Search in tags, names and values</source>
        <translation>In Tags, Namen und Werten suchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Attributes</source>
        <translation>Attribute</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>VR</source>
        <translation>VR</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copies the selected attributes, or all that are shown (Ctrl+C)</source>
        <translation>Kopiert die gewählten Attribute oder alle angezeigten (Strg+C)</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> von %1</translation>
    </message>
    <message>
        <source>%1: attributes: %2</source>
        <translation>%1: Attribute: %2</translation>
    </message>
</context>
<context>
    <name>varimarch::TimeBar</name>
    <message>
        <source>Speed of the times</source>
        <translation>Geschwindigkeit der Zeitpunkte</translation>
    </message>
    <message>
        <source>&amp;Play the times</source>
        <translation>Zeitpunkte ab&amp;spielen</translation>
    </message>
    <message>
        <source>P&amp;revious time</source>
        <translation>&amp;Voriger Zeitpunkt</translation>
    </message>
    <message>
        <source>&amp;Next time</source>
        <translation>&amp;Nächster Zeitpunkt</translation>
    </message>
    <message>
        <source>Repe&amp;at</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Curve at the crosshair</source>
        <translation>&amp;Kurve am Fadenkreuz</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeitpunkt</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeitpunkt</translation>
    </message>
    <message>
        <source>As acquired</source>
        <translation>Wie aufgenommen</translation>
    </message>
    <message>
        <source>%1 a second</source>
        <translation>%1 pro Sekunde</translation>
    </message>
    <message>
        <source>%1, loading…</source>
        <translation>%1, wird geladen…</translation>
    </message>
    <message>
        <source>play</source>
        <translation>abspielen</translation>
    </message>
</context>
<context>
    <name>varimarch::TimeCurve</name>
    <message>
        <source>Value over time at the crosshair</source>
        <translation>Wert am Fadenkreuz im Lauf der Zeit</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Als CSV kopieren</translation>
    </message>
    <message>
        <source>Ctrl+C copies the values as CSV</source>
        <translation>Strg+C kopiert die Werte als CSV</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeitpunkt</translation>
    </message>
    <message>
        <source>%1 at the crosshair, %2 of %3 times</source>
        <translation>%1 am Fadenkreuz, %2 von %3 Zeitpunkten</translation>
    </message>
</context>
<context>
    <name>varimarch::ToolMenu</name>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Mark a key image</source>
        <translation>Schlüsselbild &amp;merken</translation>
    </message>
    <message>
        <source>&amp;Rotate</source>
        <translation>&amp;Drehen</translation>
    </message>
    <message>
        <source>Drag to rotate the volume</source>
        <translation>Ziehen dreht das Volumen</translation>
    </message>
    <message>
        <source>Wa&amp;lk</source>
        <translation>Ge&amp;hen</translation>
    </message>
    <message>
        <source>Walk through the volume: W, A, S, D or arrow keys, E and Q; drag to look around</source>
        <translation>Durch das Volumen gehen: W, A, S, D oder Pfeiltasten, E und Q; Ziehen blickt umher</translation>
    </message>
    <message>
        <source>&amp;Window/Level</source>
        <translation>&amp;Fenster/Mitte</translation>
    </message>
    <message>
        <source>Drag sideways for the window, up and down for the level; or drag with Ctrl</source>
        <translation>Quer ziehen für das Fenster, auf und ab für die Mitte; auch Strg und ziehen</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Strecke</translation>
    </message>
    <message>
        <source>Drag from one point to another</source>
        <translation>Von einem Punkt zu einem anderen ziehen</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>Drag from the end of one arm to the vertex, then press at the end of the other</source>
        <translation>Vom Ende eines Schenkels zum Scheitel ziehen, dann am Ende des anderen drücken</translation>
    </message>
    <message>
        <source>B&amp;ox</source>
        <translation>&amp;Quader</translation>
    </message>
    <message>
        <source>Drag from corner to corner: mean, deviation, volume</source>
        <translation>Von Ecke zu Ecke ziehen: Mittel, Streuung, Volumen</translation>
    </message>
    <message>
        <source>&amp;Scissors</source>
        <translation>S&amp;chere</translation>
    </message>
    <message>
        <source>Draw around the part to remove</source>
        <translation>Den Teil umfahren, der weg soll</translation>
    </message>
    <message>
        <source>&amp;Keep inside</source>
        <translation>Inneres &amp;behalten</translation>
    </message>
    <message>
        <source>Draw around the part to keep</source>
        <translation>Den Teil umfahren, der bleiben soll</translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>Annotate</source>
        <translation>Beschriften</translation>
    </message>
    <message>
        <source>Cobb angles, regions, curves, arrows and texts</source>
        <translation>Cobb-Winkel, Regionen, Kurven, Pfeile und Texte</translation>
    </message>
    <message>
        <source>Anno&amp;tate</source>
        <translation>Beschrifte&amp;n</translation>
    </message>
    <message>
        <source>&amp;Cobb angle</source>
        <translation>&amp;Cobb-Winkel</translation>
    </message>
    <message>
        <source>Drag along one line, then another</source>
        <translation>Eine Linie entlang ziehen, dann eine zweite</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>&amp;Ellipse</translation>
    </message>
    <message>
        <source>Drag across a slice: area, mean, deviation, smallest and largest value</source>
        <translation>Über eine Schicht ziehen: Fläche, Mittelwert, Abweichung, kleinster und größter Wert</translation>
    </message>
    <message>
        <source>&amp;Freehand region</source>
        <translation>&amp;Freihand-Region</translation>
    </message>
    <message>
        <source>Draw around a region of a slice: area, mean, deviation, smallest and largest value</source>
        <translation>Eine Region einer Schicht umfahren: Fläche, Mittelwert, Abweichung, kleinster und größter Wert</translation>
    </message>
    <message>
        <source>C&amp;urve</source>
        <translation>K&amp;urve</translation>
    </message>
    <message>
        <source>Click along a vessel or the jaw: its length, and the volume straightened along it</source>
        <translation>An einem Gefäß oder dem Kiefer entlang klicken: die Länge, und das Volumen daran begradigt</translation>
    </message>
    <message>
        <source>&amp;Arrow</source>
        <translation>&amp;Pfeil</translation>
    </message>
    <message>
        <source>Drag to the thing to show, then type</source>
        <translation>Zu dem ziehen, was gezeigt werden soll, dann tippen</translation>
    </message>
    <message>
        <source>&amp;Text</source>
        <translation>&amp;Text</translation>
    </message>
    <message>
        <source>Click, then type</source>
        <translation>Klicken, dann tippen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;No comparison</source>
        <translation>&amp;Kein Vergleich</translation>
    </message>
    <message>
        <source>Compare with VTK&apos;s &amp;GPU mapper</source>
        <translation>Mit VTKs &amp;GPU-Mapper vergleichen</translation>
    </message>
    <message>
        <source>Compare with VTK&apos;s CP&amp;U mapper</source>
        <translation>Mit VTKs CP&amp;U-Mapper vergleichen</translation>
    </message>
    <message>
        <source>W&amp;ipe between them</source>
        <translation>Da&amp;zwischen wischen</translation>
    </message>
    <message>
        <source>Both images in one place, with a divider to drag</source>
        <translation>Beide Bilder an einem Ort, mit einer Trennlinie zum Ziehen</translation>
    </message>
    <message>
        <source>Benc&amp;hmark…</source>
        <translation>&amp;Leistungsvergleich…</translation>
    </message>
</context>
<context>
    <name>varimarch::Tour</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>Tour: %1 of %2</source>
        <translation>Rundgang: %1 von %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
</context>
<context>
    <name>varimarch::TransferFunctionEditor</name>
    <message>
        <source>Edit numbers…</source>
        <translation>Zahlen bearbeiten…</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Add a point after the selected one</source>
        <translation>Punkt nach dem gewählten einfügen</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alle wählen</translation>
    </message>
    <message>
        <source>Show all values</source>
        <translation>Alle Werte zeigen</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Hide the outermost 1 % of the voxels</source>
        <translation>Das äußerste 1 % der Voxel ausblenden</translation>
    </message>
    <message>
        <source>99 %</source>
        <translation>99 %</translation>
    </message>
    <message>
        <source>Show the curve</source>
        <translation>Die Kurve zeigen</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Logarithmic counts</source>
        <translation>Logarithmische Anzahlen</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>Enlarge low opacities</source>
        <translation>Geringe Deckkraft vergrößern</translation>
    </message>
    <message>
        <source>nudge points</source>
        <translation>Punkte rücken</translation>
    </message>
    <message>
        <source>delete points</source>
        <translation>Punkte löschen</translation>
    </message>
    <message>
        <source>delete point</source>
        <translation>Punkt löschen</translation>
    </message>
    <message>
        <source>add point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>choose colour</source>
        <translation>Farbe wählen</translation>
    </message>
    <message>
        <source>edit point</source>
        <translation>Punkt bearbeiten</translation>
    </message>
    <message>
        <source>Add a point here</source>
        <translation>Hier einen Punkt hinzufügen</translation>
    </message>
    <message>
        <source>move points</source>
        <translation>Punkte bewegen</translation>
    </message>
    <message>
        <source>move colour</source>
        <translation>Farbe bewegen</translation>
    </message>
    <message>
        <source>move point</source>
        <translation>Punkt bewegen</translation>
    </message>
    <message>
        <source>shift the curve</source>
        <translation>Kurve verschieben</translation>
    </message>
    <message>
        <source>add colour</source>
        <translation>Farbe hinzufügen</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>scale the curve</source>
        <translation>Kurve strecken</translation>
    </message>
    <message>
        <source>Low</source>
        <translation>Gering</translation>
    </message>
    <message>
        <source>Ask for the colour of a new point</source>
        <translation>Nach der Farbe eines neuen Punkts fragen</translation>
    </message>
</context>
<context>
    <name>varimarch::ViewMenu</name>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Background…</source>
        <translation>Hinter&amp;grund…</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Bedi&amp;enfelder</translation>
    </message>
    <message>
        <source>&amp;Anterior</source>
        <translation>Von &amp;vorn</translation>
    </message>
    <message>
        <source>&amp;Posterior</source>
        <translation>Von &amp;hinten</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Von &amp;links</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>Von &amp;rechts</translation>
    </message>
    <message>
        <source>&amp;Superior</source>
        <translation>Von &amp;oben</translation>
    </message>
    <message>
        <source>&amp;Inferior</source>
        <translation>Von &amp;unten</translation>
    </message>
    <message>
        <source>standard view</source>
        <translation>Standardansicht</translation>
    </message>
    <message>
        <source>Parall&amp;el projection</source>
        <translation>&amp;Parallelprojektion</translation>
    </message>
    <message>
        <source>No perspective: distant objects look as large as near ones</source>
        <translation>Ohne Perspektive: Fernes erscheint so groß wie Nahes</translation>
    </message>
    <message>
        <source>projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>&amp;Window of the slices</source>
        <translation>Fen&amp;ster der Schichten</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Wie in der Datei</translation>
    </message>
    <message>
        <source>&amp;%1  %2</source>
        <translation>&amp;%1  %2</translation>
    </message>
    <message>
        <source>Or click a slice and press %1</source>
        <translation>Oder eine Schicht anklicken und %1 drücken</translation>
    </message>
    <message>
        <source>&amp;Volume large</source>
        <translation>Volu&amp;men groß</translation>
    </message>
    <message>
        <source>&amp;Four views alike</source>
        <translation>Vier &amp;Ansichten gleich groß</translation>
    </message>
    <message>
        <source>Double-click a view to see it alone, and again to see all</source>
        <translation>Ein Doppelklick zeigt eine Ansicht allein, ein weiterer alle</translation>
    </message>
    <message>
        <source>Full s&amp;creen</source>
        <translation>Vollbil&amp;d</translation>
    </message>
    <message>
        <source>&amp;Window, level and zoom</source>
        <translation>&amp;Fenster, Mitte und Zoom</translation>
    </message>
    <message>
        <source>&amp;Number of the slice</source>
        <translation>&amp;Nummer der Schicht</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>&amp;Position</translation>
    </message>
    <message>
        <source>Thickness of the &amp;slab</source>
        <translation>&amp;Dicke der Schicht</translation>
    </message>
    <message>
        <source>S&amp;cale bar</source>
        <translation>&amp;Maßstab</translation>
    </message>
    <message>
        <source>&amp;Directions of the patient</source>
        <translation>&amp;Richtungen des Patienten</translation>
    </message>
    <message>
        <source>Te&amp;xts over the slices</source>
        <translation>Te&amp;xte über den Schichten</translation>
    </message>
    <message>
        <source>&amp;Times</source>
        <translation>&amp;Zeitpunkte</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>From the darkest to the brightest values of the scan</source>
        <translation>Von den dunkelsten bis zu den hellsten Werten der Aufnahme</translation>
    </message>
</context>
<context>
    <name>varimarch::VolumeView</name>
    <message>
        <source>turn the camera</source>
        <translation>Kamera drehen</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
</context>
<context>
    <name>varimarch::VolumesPanel</name>
    <message>
        <source>computed volume</source>
        <translation>berechnetes Volumen</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>The look panels change the selected volume</source>
        <translation>Die Felder für das Aussehen ändern das ausgewählte Volumen</translation>
    </message>
    <message>
        <source>Add a scan…</source>
        <translation>Aufnahme hinzufügen…</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Opacity of the volume</source>
        <translation>Deckkraft des Volumens</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Hot</source>
        <translation>Heiß</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>In slices</source>
        <translation>In Schichten</translation>
    </message>
    <message>
        <source>opacity of a volume</source>
        <translation>Deckkraft eines Volumens</translation>
    </message>
    <message>
        <source>colours in slices</source>
        <translation>Farben in Schichten</translation>
    </message>
    <message>
        <source>Place beside its patient coordinates</source>
        <translation>Lage neben den Patientenkoordinaten</translation>
    </message>
    <message>
        <source>Move to the patient&apos;s left</source>
        <translation>Nach links des Patienten verschieben</translation>
    </message>
    <message>
        <source>Move to the back</source>
        <translation>Nach hinten verschieben</translation>
    </message>
    <message>
        <source>Move to the head</source>
        <translation>Zum Kopf verschieben</translation>
    </message>
    <message>
        <source>Turn about the axis to the left</source>
        <translation>Um die Achse nach links drehen</translation>
    </message>
    <message>
        <source>Turn about the axis to the back</source>
        <translation>Um die Achse nach hinten drehen</translation>
    </message>
    <message>
        <source>Turn about the axis to the head</source>
        <translation>Um die Achse zum Kopf drehen</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Patient coordinates</source>
        <translation>Patientenkoordinaten</translation>
    </message>
    <message>
        <source>patient coordinates</source>
        <translation>Patientenkoordinaten</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Registrieren</translation>
    </message>
    <message>
        <source>Finds the place where the volume fits the first one best, as a rigid body</source>
        <translation>Findet die Lage, in der das Volumen als starrer Körper am besten auf das erste passt</translation>
    </message>
    <message>
        <source>rename</source>
        <translation>umbenennen</translation>
    </message>
    <message>
        <source>show a volume</source>
        <translation>Volumen zeigen</translation>
    </message>
    <message>
        <source>hide a volume</source>
        <translation>Volumen verbergen</translation>
    </message>
    <message>
        <source>move a volume</source>
        <translation>Volumen verschieben</translation>
    </message>
    <message>
        <source>order of volumes</source>
        <translation>Reihenfolge der Volumen</translation>
    </message>
    <message>
        <source>remove a volume</source>
        <translation>Volumen entfernen</translation>
    </message>
    <message>
        <source>Move to the left, to the back, to the head</source>
        <translation>Nach links, nach hinten, zum Kopf verschieben</translation>
    </message>
    <message>
        <source>Turn about these axes</source>
        <translation>Um diese Achsen drehen</translation>
    </message>
    <message>
        <source>Several volumes are drawn together as composites.</source>
        <translation>Mehrere Volumen werden gemeinsam gezeichnet, als Überlagerung.</translation>
    </message>
    <message>
        <source>Registering</source>
        <translation>Registrierung</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cannot register</source>
        <translation>Registrierung nicht möglich</translation>
    </message>
    <message>
        <source>register a volume</source>
        <translation>Volumen registrieren</translation>
    </message>
</context>
<context>
    <name>varimarch::WarningBar</name>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Rectify</source>
        <translation>Entzerren</translation>
    </message>
    <message>
        <source>Show as scanned</source>
        <translation>Wie aufgenommen zeigen</translation>
    </message>
    <message>
        <source>Open all images</source>
        <translation>Alle Bilder öffnen</translation>
    </message>
    <message>
        <source>This image belongs to a series of %1 images.</source>
        <translation>Dieses Bild gehört zu einer Serie von %1 Bildern.</translation>
    </message>
</context>
</TS>
