<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>App::Property</name>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Further parts</source>
        <translation>Weitere Teile</translation>
    </message>
    <message>
        <source>Earlier parts</source>
        <translation>Frühere Teile</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Abgeschaltet</translation>
    </message>
    <message>
        <source>Earlier rounds</source>
        <translation>Frühere Runden</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Sollkontur</translation>
    </message>
    <message>
        <source>Tool diameter</source>
        <translation>Werkzeugdurchmesser</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Einpassung</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Annehmen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Einrichtung</translation>
    </message>
    <message>
        <source>Iterate</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Next depth</source>
        <translation>Nächste Tiefe</translation>
    </message>
    <message>
        <source>Depth along</source>
        <translation>Tiefe entlang</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Übertragungsfunktion</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>Leave stock</source>
        <translation>Aufmaß lassen</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Totband</translation>
    </message>
    <message>
        <source>Unmeasured share</source>
        <translation>Anteil ohne Messpunkte</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Keep allowance</source>
        <translation>Aufmaß mitführen</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Output moves</source>
        <translation>Ausgegebene Sätze</translation>
    </message>
    <message>
        <source>Cutter compensation</source>
        <translation>Fräserkorrektur</translation>
    </message>
    <message>
        <source>Deviation mean</source>
        <translation>Abweichung Mittel</translation>
    </message>
    <message>
        <source>Deviation min</source>
        <translation>Abweichung kleinste</translation>
    </message>
    <message>
        <source>Deviation max</source>
        <translation>Abweichung größte</translation>
    </message>
    <message>
        <source>Deviation height</source>
        <translation>Abweichung Spanne</translation>
    </message>
    <message>
        <source>Deviation std</source>
        <translation>Abweichung Std.</translation>
    </message>
    <message>
        <source>Random std</source>
        <translation>Streuung Std.</translation>
    </message>
    <message>
        <source>Largest correction</source>
        <translation>Größte Korrektur</translation>
    </message>
    <message>
        <source>Path error</source>
        <translation>Bahnfehler</translation>
    </message>
    <message>
        <source>Points used</source>
        <translation>Benutzte Punkte</translation>
    </message>
    <message>
        <source>Points rejected</source>
        <translation>Verworfene Punkte</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Digest</source>
        <translation>Prüfsumme</translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation>Korrigiert</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Geglättet</translation>
    </message>
    <message>
        <source>Noted</source>
        <translation>Zur Kenntnis genommen</translation>
    </message>
    <message>
        <source>Cut path</source>
        <translation>Gefräste Bahn</translation>
    </message>
    <message>
        <source>The operation whose path is corrected</source>
        <translation>Die Operation, deren Bahn korrigiert wird</translation>
    </message>
    <message>
        <source>The measured part; without one the path is made exact and nothing is corrected</source>
        <translation>Das gemessene Teil; ohne eines wird die Bahn genau gelegt und nichts korrigiert</translation>
    </message>
    <message>
        <source>Measurements of further parts cut with the same path; deviations are averaged</source>
        <translation>Messungen weiterer Teile mit derselben Bahn; die Abweichungen werden gemittelt</translation>
    </message>
    <message>
        <source>Parts measured in earlier rounds, oldest first; the later ones were cut with their path</source>
        <translation>In früheren Runden gemessene Teile, das älteste zuerst; die späteren wurden mit deren Bahn gefräst</translation>
    </message>
    <message>
        <source>Measured parts that count for nothing</source>
        <translation>Gemessene Teile, die nicht zählen</translation>
    </message>
    <message>
        <source>Number of parts and settings of each earlier round</source>
        <translation>Anzahl der Teile und Einstellungen jeder früheren Runde</translation>
    </message>
    <message>
        <source>Nominal profile; without one the operation's own geometry, or else its path</source>
        <translation>Sollkontur; ohne eine die Geometrie der Operation, sonst ihre Bahn</translation>
    </message>
    <message>
        <source>Diameter of the tool; 0 takes it from the tool controller</source>
        <translation>Durchmesser des Werkzeugs; 0 nimmt ihn aus der Werkzeugsteuerung</translation>
    </message>
    <message>
        <source>Side of the contour on which the tool runs, along its direction</source>
        <translation>Seite der Kontur, auf der das Werkzeug in seiner Richtung läuft</translation>
    </message>
    <message>
        <source>Best fit of the measured points before comparing: none, shift, rigid, or some of x, y, turn joined by +</source>
        <translation>Einpassung der Messpunkte vor dem Vergleich: none, shift, rigid oder einige von x, y, turn, mit + verbunden</translation>
    </message>
    <message>
        <source>Findings about the measurement that are accepted by name</source>
        <translation>Befunde zur Messung, die namentlich angenommen sind</translation>
    </message>
    <message>
        <source>What separates form from scatter: none, mean:5, mean:1,2,3,2,1, gauss:MM or auto</source>
        <translation>Was Form von Streuung trennt: none, mean:5, mean:1,2,3,2,1, gauss:MM oder auto</translation>
    </message>
    <message>
        <source>How the path answers a deviation</source>
        <translation>Wie die Bahn auf eine Abweichung antwortet</translation>
    </message>
    <message>
        <source>TOML file with tool, material, machine and stock, kept in the document</source>
        <translation>TOML-Datei mit Werkzeug, Werkstoff, Maschine und Rohteil, im Dokument aufbewahrt</translation>
    </message>
    <message>
        <source>Correct again in the model until the error to expect is at most this; 0: only once</source>
        <translation>Im Modell weiter korrigieren, bis der erwartete Fehler höchstens so groß ist; 0: nur einmal</translation>
    </message>
    <message>
        <source>Depth along the normal that the measured part was cut at; one, or one a part</source>
        <translation>Tiefe entlang der Normalen, mit der das gemessene Teil geschnitten wurde; eine, oder eine je Teil</translation>
    </message>
    <message>
        <source>Depth that the corrected path will cut; 0: that of the measured part</source>
        <translation>Tiefe, die die korrigierte Bahn fräsen wird; 0: die des gemessenen Teils</translation>
    </message>
    <message>
        <source>How deviations are taken: along the normal, or along one axis</source>
        <translation>Wie Abweichungen genommen werden: längs der Normalen oder längs einer Achse</translation>
    </message>
    <message>
        <source>Smooth along the contour, one value, or one a point</source>
        <translation>Geglättet längs der Kontur, ein Wert, oder einer je Punkt</translation>
    </message>
    <message>
        <source>Stock that the path of the measured part left on the nominal</source>
        <translation>Aufmaß, das die Bahn des gemessenen Teils auf der Sollkontur gelassen hat</translation>
    </message>
    <message>
        <source>Stock that the path leaves on the part: a first cut, before anything is measured</source>
        <translation>Aufmaß, das die Bahn auf dem Teil lässt: ein erster Schnitt, bevor gemessen wird</translation>
    </message>
    <message>
        <source>Share of the deviation taken back</source>
        <translation>Anteil der Abweichung, der zurückgenommen wird</translation>
    </message>
    <message>
        <source>Largest correction; a larger one is refused</source>
        <translation>Größte Korrektur; eine größere wird verweigert</translation>
    </message>
    <message>
        <source>Deviations up to this are left alone</source>
        <translation>Abweichungen bis hierher bleiben unberührt</translation>
    </message>
    <message>
        <source>Largest share of a contour without points near that is corrected all the same</source>
        <translation>Größter Anteil einer Kontur ohne Punkte in der Nähe, der trotzdem korrigiert wird</translation>
    </message>
    <message>
        <source>Diameters of other tools of the path, each as 3=16 or ROUGH=16</source>
        <translation>Durchmesser weiterer Werkzeuge der Bahn, jeder wie 3=16 oder ROUGH=16</translation>
    </message>
    <message>
        <source>Passes that rough along the contour are moved with it</source>
        <translation>Schruppbahnen entlang der Kontur werden mit ihr verschoben</translation>
    </message>
    <message>
        <source>Largest distance of the path from the exact one</source>
        <translation>Größter Abstand der Bahn von der genauen</translation>
    </message>
    <message>
        <source>Moves of the corrected path: as the operation's, only lines, or arcs</source>
        <translation>Sätze der korrigierten Bahn: wie die der Operation, nur Geraden, oder Bögen</translation>
    </message>
    <message>
        <source>What a path under G41 or G42 is: the contour itself, or the centre path</source>
        <translation>Was eine Bahn unter G41 oder G42 ist: die Kontur selbst oder die Mittelpunktsbahn</translation>
    </message>
    <message>
        <source>Mean deviation</source>
        <translation>Mittlere Abweichung</translation>
    </message>
    <message>
        <source>Least deviation</source>
        <translation>Kleinste Abweichung</translation>
    </message>
    <message>
        <source>Greatest deviation</source>
        <translation>Größte Abweichung</translation>
    </message>
    <message>
        <source>Greatest less least</source>
        <translation>Größte weniger kleinste</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Standardabweichung</translation>
    </message>
    <message>
        <source>Standard deviation of what the filter takes for scatter</source>
        <translation>Standardabweichung dessen, was der Filter für Streuung hält</translation>
    </message>
    <message>
        <source>Largest distance of the path from the exact offset of the compensated profile</source>
        <translation>Größter Abstand der Bahn von der genauen Parallelen des korrigierten Profils</translation>
    </message>
    <message>
        <source>Points left out</source>
        <translation>Ausgelassene Punkte</translation>
    </message>
    <message>
        <source>What to know</source>
        <translation>Was zu wissen ist</translation>
    </message>
    <message>
        <source>Measured file of this correction</source>
        <translation>Messdatei dieser Korrektur</translation>
    </message>
    <message>
        <source>SHA-256 of that file</source>
        <translation>SHA-256 dieser Datei</translation>
    </message>
    <message>
        <source>When the correction was made</source>
        <translation>Wann die Korrektur gemacht wurde</translation>
    </message>
    <message>
        <source>Deviation smoothed over the parts of a series, which is taken out in place of the measured one</source>
        <translation>Über die Teile einer Serie geglättete Abweichung, die anstelle der gemessenen herausgenommen wird</translation>
    </message>
    <message>
        <source>Warnings that were there when the user last looked at the correction</source>
        <translation>Warnungen, die da waren, als der Benutzer die Korrektur zuletzt ansah</translation>
    </message>
    <message>
        <source>SHA-256 of the measurement, and of the operation's path when it came</source>
        <translation>SHA-256 der Messung und der Bahn der Operation, als sie kam</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Ball radius</source>
        <translation>Kugelradius</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Taster</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Work offset</source>
        <translation>Nullpunkt</translation>
    </message>
    <message>
        <source>Work offset given</source>
        <translation>Nullpunkt gilt</translation>
    </message>
    <message>
        <source>Work rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Höhen</translation>
    </message>
    <message>
        <source>Has z</source>
        <translation>Hat Z</translation>
    </message>
    <message>
        <source>The measured file, kept in the document</source>
        <translation>Die Messdatei, im Dokument aufbewahrt</translation>
    </message>
    <message>
        <source>What the coordinates are: points on the surface or centres of the probe's ball</source>
        <translation>Was die Koordinaten sind: Punkte auf der Oberfläche oder Mittelpunkte der Tastkugel</translation>
    </message>
    <message>
        <source>Radius of the probe's ball where the points are centres; 0: as the file says</source>
        <translation>Radius der Tastkugel, wenn die Punkte Mittelpunkte sind; 0: wie die Datei sagt</translation>
    </message>
    <message>
        <source>Unit of length in the file</source>
        <translation>Längeneinheit der Datei</translation>
    </message>
    <message>
        <source>Format of the file; empty: by its content</source>
        <translation>Format der Datei; leer: nach dem Inhalt</translation>
    </message>
    <message>
        <source>TOML file that says what the columns of a text file are, kept in the document</source>
        <translation>TOML-Datei, die sagt, was die Spalten einer Textdatei sind, im Dokument aufbewahrt</translation>
    </message>
    <message>
        <source>TOML file with the calibration of the probe, kept in the document</source>
        <translation>TOML-Datei mit der Kalibrierung des Tasters, im Dokument aufbewahrt</translation>
    </message>
    <message>
        <source>Which of several measured parts in the file, from 1; 0: it holds one</source>
        <translation>Welches von mehreren Teilen der Datei, ab 1; 0: sie enthält eines</translation>
    </message>
    <message>
        <source>Origin of the work frame in the frame of the file, mm</source>
        <translation>Ursprung des Werkstücksystems im System der Datei, mm</translation>
    </message>
    <message>
        <source>The work offset holds; otherwise what the file says</source>
        <translation>Der Nullpunkt gilt; sonst, was die Datei sagt</translation>
    </message>
    <message>
        <source>Turn of the work frame in the frame of the file, anticlockwise</source>
        <translation>Drehung des Werkstücksystems im System der Datei, gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Name of the file</source>
        <translation>Name der Datei</translation>
    </message>
    <message>
        <source>SHA-256 of the file</source>
        <translation>SHA-256 der Datei</translation>
    </message>
    <message>
        <source>Number of points</source>
        <translation>Anzahl der Punkte</translation>
    </message>
    <message>
        <source>Number of Z levels</source>
        <translation>Anzahl der Z-Höhen</translation>
    </message>
    <message>
        <source>The file has a Z coordinate</source>
        <translation>Die Datei hat eine Z-Koordinate</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Korrektur</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Magnification</source>
        <translation>Vergrößerung</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Spanne</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>Poles</source>
        <translation>Pole</translation>
    </message>
    <message>
        <source>Contour length</source>
        <translation>Konturlänge</translation>
    </message>
    <message>
        <source>The dressup whose compensated profile this is</source>
        <translation>Die korrigierte Bahn, deren Profil dies ist</translation>
    </message>
    <message>
        <source>The profile to cut so that the part comes out right, the nominal one, the operation's path along it, the points as measured, those on the surface, or the deviations as lines along the normal</source>
        <translation>Das Profil, das zu fräsen ist, damit das Teil stimmt, das Sollprofil, die Bahn der Operation daran, die Punkte wie gemessen, die auf der Oberfläche, oder die Abweichungen als Linien längs der Normalen</translation>
    </message>
    <message>
        <source>So many times longer than they are the deviations are drawn</source>
        <translation>So viel länger als sie sind werden die Abweichungen gezeichnet</translation>
    </message>
    <message>
        <source>Z of the profile</source>
        <translation>Z des Profils</translation>
    </message>
    <message>
        <source>Highest degree</source>
        <translation>Höchster Grad</translation>
    </message>
    <message>
        <source>Number of poles</source>
        <translation>Anzahl der Pole</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Path tolerance</source>
        <translation>Bahntoleranz</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Stapel</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Jobs to run</source>
        <translation>Aufträge, die laufen sollen</translation>
    </message>
    <message>
        <source>Also run what an earlier run has done</source>
        <translation>Auch, was ein früherer Lauf getan hat</translation>
    </message>
    <message>
        <source>Journal of a series</source>
        <translation>Journal einer Serie</translation>
    </message>
    <message>
        <source>Directory for the report and the table of all parts</source>
        <translation>Verzeichnis für den Bericht und die Tabelle aller Teile</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>Points count</source>
        <translation>Anzahl Punkte</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Antastung</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Safe z</source>
        <translation>Sicheres Z</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Freiraum</translation>
    </message>
    <message>
        <source>Overtravel</source>
        <translation>Überlauf</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>Free width</source>
        <translation>Freie Breite</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Positioning feed</source>
        <translation>Positioniervorschub</translation>
    </message>
    <message>
        <source>Probe tool</source>
        <translation>Werkzeugnummer des Tasters</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Control that runs it</source>
        <translation>Steuerung, auf der es läuft</translation>
    </message>
    <message>
        <source>Measuring program to write</source>
        <translation>Messprogramm, das geschrieben wird</translation>
    </message>
    <message>
        <source>Radius at which the probe triggers, as calibrated</source>
        <translation>Radius, bei dem der Taster schaltet, wie kalibriert</translation>
    </message>
    <message>
        <source>Number of points; 0: by their distance</source>
        <translation>Anzahl der Punkte; 0: nach ihrem Abstand</translation>
    </message>
    <message>
        <source>Distance of points along the contour</source>
        <translation>Abstand der Punkte längs der Kontur</translation>
    </message>
    <message>
        <source>Denser where the contour bends</source>
        <translation>Dichter, wo die Kontur sich krümmt</translation>
    </message>
    <message>
        <source>Along an axis where the slope allows it, always along an axis, or along the normal</source>
        <translation>Längs einer Achse, wo die Neigung es erlaubt, immer längs einer Achse, oder längs der Normalen</translation>
    </message>
    <message>
        <source>Height to measure at</source>
        <translation>Höhe, in der gemessen wird</translation>
    </message>
    <message>
        <source>Height at which the probe passes over everything</source>
        <translation>Höhe, in der der Taster über alles hinweggeht</translation>
    </message>
    <message>
        <source>Distance from which a touch begins</source>
        <translation>Abstand, aus dem eine Antastung beginnt</translation>
    </message>
    <message>
        <source>How far behind the surface a touch gives up</source>
        <translation>Wie weit hinter der Oberfläche eine Antastung aufgibt</translation>
    </message>
    <message>
        <source>Stock that is still on the contour</source>
        <translation>Aufmaß, das noch auf der Kontur steht</translation>
    </message>
    <message>
        <source>How far beside the contour it is free; 0: everywhere</source>
        <translation>Wie weit es neben der Kontur frei ist; 0: überall</translation>
    </message>
    <message>
        <source>Contour to measure, where it is not the operation's own</source>
        <translation>Zu messende Kontur, wenn es nicht die der Operation ist</translation>
    </message>
    <message>
        <source>Feed of the touch</source>
        <translation>Vorschub der Antastung</translation>
    </message>
    <message>
        <source>Feed of moves at measuring height</source>
        <translation>Vorschub der Wege in Messhöhe</translation>
    </message>
    <message>
        <source>Number of the probe in the magazine; 0: it is in use</source>
        <translation>Nummer des Tasters im Magazin; 0: er ist eingewechselt</translation>
    </message>
    <message>
        <source>Name of the file the control writes; empty: as usual</source>
        <translation>Name der Datei, die die Steuerung schreibt; leer: wie üblich</translation>
    </message>
    <message>
        <source>Show picture</source>
        <translation>Bild zeigen</translation>
    </message>
    <message>
        <source>Automatic magnification</source>
        <translation>Selbsttätige Vergrößerung</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Oberes Abmaß</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Unteres Abmaß</translation>
    </message>
    <message>
        <source>Material left</source>
        <translation>Stehendes Material</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Whiskers</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Band</source>
        <translation>Band</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profile</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>Rejected points</source>
        <translation>Verworfene Punkte</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Show the deviations in the 3-D view</source>
        <translation>Die Abweichungen in der 3D-Ansicht zeigen</translation>
    </message>
    <message>
        <source>Deviations and the part's size decide how much larger deviations are drawn</source>
        <translation>Abweichungen und Größe des Teils entscheiden, wie viel größer Abweichungen gezeichnet werden</translation>
    </message>
    <message>
        <source>So many times longer than they are deviations and differences are drawn, as far as it turns no contour inside out</source>
        <translation>So viel länger werden Abweichungen und Unterschiede gezeichnet, soweit es keine Kontur umstülpt</translation>
    </message>
    <message>
        <source>Larger deviations are out of tolerance: too much material is left</source>
        <translation>Größere Abweichungen liegen außerhalb der Toleranz: zu viel Material steht</translation>
    </message>
    <message>
        <source>Smaller deviations are out of tolerance: too much is cut away</source>
        <translation>Kleinere Abweichungen liegen außerhalb der Toleranz: zu viel ist weggeschnitten</translation>
    </message>
    <message>
        <source>Colour of material left; measuring machines' programs show it red</source>
        <translation>Farbe stehenden Materials; Programme von Messmaschinen zeigen es rot</translation>
    </message>
    <message>
        <source>Show the deviation as the colour of the wall itself</source>
        <translation>Die Abweichung als Farbe der Wand selbst zeigen</translation>
    </message>
    <message>
        <source>Show each deviation as a line</source>
        <translation>Jede Abweichung als Strich zeigen</translation>
    </message>
    <message>
        <source>Show the tolerance band</source>
        <translation>Das Toleranzband zeigen</translation>
    </message>
    <message>
        <source>Show nominal and compensated profile</source>
        <translation>Soll- und korrigiertes Profil zeigen</translation>
    </message>
    <message>
        <source>Show the path before and after</source>
        <translation>Die Bahn vorher und nachher zeigen</translation>
    </message>
    <message>
        <source>Mark points that are left out</source>
        <translation>Ausgelassene Punkte bezeichnen</translation>
    </message>
    <message>
        <source>Show what the colours mean</source>
        <translation>Zeigen, was die Farben bedeuten</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>NC program that cut the measured part</source>
        <translation>NC-Programm, mit dem das gemessene Teil gefräst wurde</translation>
    </message>
    <message>
        <source>Diameter of the cutter</source>
        <translation>Durchmesser des Fräsers</translation>
    </message>
    <message>
        <source>Contour the part should have: a drawing, or the first program; empty: the program's</source>
        <translation>Kontur, die das Teil haben soll: eine Zeichnung oder das erste Programm; leer: die des Programms</translation>
    </message>
    <message>
        <source>Measured points, one file a part; deviations of several parts are averaged</source>
        <translation>Messpunkte, eine Datei je Teil; die Abweichungen mehrerer Teile werden gemittelt</translation>
    </message>
    <message>
        <source>Moves of the corrected program: as the program's, only lines, arcs, or NURBS</source>
        <translation>Sätze des korrigierten Programms: wie die des Programms, nur Geraden, Bögen oder NURBS</translation>
    </message>
    <message>
        <source>Corrected program to write</source>
        <translation>Korrigiertes Programm, das geschrieben wird</translation>
    </message>
    <message>
        <source>Directory for the report; empty: none</source>
        <translation>Verzeichnis für den Bericht; leer: keiner</translation>
    </message>
    <message>
        <source>Record the part in the journal of its series</source>
        <translation>Das Teil im Journal seiner Serie festhalten</translation>
    </message>
    <message>
        <source>NC program that finishes the part</source>
        <translation>NC-Programm, das das Teil fertig fräst</translation>
    </message>
    <message>
        <source>Whole allowance over the finished contour</source>
        <translation>Ganzes Aufmaß über der fertigen Kontur</translation>
    </message>
    <message>
        <source>Share of the allowance that the first cut takes</source>
        <translation>Anteil des Aufmaßes, den der erste Schnitt nimmt</translation>
    </message>
    <message>
        <source>Program of the first cut</source>
        <translation>Programm des ersten Schnitts</translation>
    </message>
    <message>
        <source>Tool, material, machine and stock</source>
        <translation>Werkzeug, Werkstoff, Maschine und Rohteil</translation>
    </message>
    <message>
        <source>Errors and the part's size decide how much larger errors are drawn</source>
        <translation>Fehler und Größe des Teils entscheiden, wie viel größer Fehler gezeichnet werden</translation>
    </message>
    <message>
        <source>So many times larger errors are drawn</source>
        <translation>So viel größer werden Fehler gezeichnet</translation>
    </message>
    <message>
        <source>Directory for the report with all signals</source>
        <translation>Verzeichnis für den Bericht mit allen Signalen</translation>
    </message>
</context>
<context>
    <name>Millcorr</name>
    <message>
        <source>auto</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>spiegeln</translation>
    </message>
    <message>
        <source>transfer</source>
        <translation>Übertragung</translation>
    </message>
    <message>
        <source>combined</source>
        <translation>kombiniert</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>vorhergesagt</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>geglättet</translation>
    </message>
    <message>
        <source>one</source>
        <translation>eine</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>beibehalten</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>Geraden</translation>
    </message>
    <message>
        <source>arcs</source>
        <translation>Bögen</translation>
    </message>
    <message>
        <source>nurbs</source>
        <translation>NURBS</translation>
    </message>
    <message>
        <source>contour</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>wear</source>
        <translation>Verschleiß</translation>
    </message>
    <message>
        <source>the tool controller's</source>
        <translation>der des Werkzeugcontrollers</translation>
    </message>
    <message>
        <source>only once</source>
        <translation>nur einmal</translation>
    </message>
    <message>
        <source>that of the measured part</source>
        <translation>die des gemessenen Teils</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Berührpunkte</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>Mittelpunkte</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>wie die Datei sagt</translation>
    </message>
    <message>
        <source>the only one</source>
        <translation>das einzige</translation>
    </message>
    <message>
        <source>µm</source>
        <translation>µm</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source>thou</source>
        <translation>thou</translation>
    </message>
    <message>
        <source>Reading points</source>
        <translation>Punkte werden gelesen</translation>
    </message>
    <message>
        <source>Reading the program</source>
        <translation>Programm wird gelesen</translation>
    </message>
    <message>
        <source>Best fit</source>
        <translation>Einpassung</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Abweichungen</translation>
    </message>
    <message>
        <source>Looking for doubts</source>
        <translation>Suche nach Zweifeln</translation>
    </message>
    <message>
        <source>Separating form from scatter</source>
        <translation>Form wird von Streuung getrennt</translation>
    </message>
    <message>
        <source>Cutting in the model</source>
        <translation>Schnitt im Modell</translation>
    </message>
    <message>
        <source>Laying and proving the path</source>
        <translation>Bahn wird gelegt und geprüft</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Told</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Mean, {}</source>
        <translation>Mittel, {}</translation>
    </message>
    <message>
        <source>Std. deviation, {}</source>
        <translation>Standardabweichung, {}</translation>
    </message>
    <message>
        <source>Height, {}</source>
        <translation>Spanne, {}</translation>
    </message>
    <message>
        <source>Correction, {}</source>
        <translation>Korrektur, {}</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>Entscheidung</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Write report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <source>Batches (*.toml);;All files (*)</source>
        <translation>Stapel (*.toml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Journals (*.journal);;All files (*)</source>
        <translation>Journale (*.journal);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>done before</source>
        <translation>schon getan</translation>
    </message>
    <message>
        <source>done</source>
        <translation>getan</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Stapel</translation>
    </message>
    <message>
        <source>failed ({})</source>
        <translation>gescheitert ({})</translation>
    </message>
    <message>
        <source>History of parts</source>
        <translation>Verlauf der Teile</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Show as plot</source>
        <translation>Als Diagramm zeigen</translation>
    </message>
    <message>
        <source>{} of {} jobs</source>
        <translation>{} von {} Aufträgen</translation>
    </message>
    <message>
        <source>Stopped; run it again to go on</source>
        <translation>Angehalten; noch einmal starten, um fortzufahren</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>Jobs done: {} of {}</source>
        <translation>Aufträge erledigt: {} von {}</translation>
    </message>
    <message>
        <source>Done in an earlier run: {}</source>
        <translation>In einem früheren Lauf erledigt: {}</translation>
    </message>
    <message>
        <source>Failed: {}</source>
        <translation>Fehlgeschlagen: {}</translation>
    </message>
    <message>
        <source>the open task ended: OK or Cancel</source>
        <translation>die offene Aufgabe beendet: OK oder Abbrechen</translation>
    </message>
    <message>
        <source>Needs:</source>
        <translation>Braucht:</translation>
    </message>
    <message>
        <source>the operation's own contour</source>
        <translation>die Kontur der Operation selbst</translation>
    </message>
    <message>
        <source>Compensated toolpath</source>
        <translation>Korrigierte Bahn</translation>
    </message>
    <message>
        <source>Measured parts</source>
        <translation>Gemessene Teile</translation>
    </message>
    <message>
        <source>Measured part</source>
        <translation>Gemessenes Teil</translation>
    </message>
    <message>
        <source>Oldest first. Each part was cut with the path that those before it gave; what is not ticked counts for nothing.</source>
        <translation>Das älteste zuerst. Jedes Teil wurde mit der Bahn gefräst, die die Teile davor ergaben; was nicht angehakt ist, zählt nicht.</translation>
    </message>
    <message>
        <source>&amp;Import file…</source>
        <translation>Datei &amp;importieren…</translation>
    </message>
    <message>
        <source>Point at a whisker to see its point; click to keep it.</source>
        <translation>Auf einen Strich zeigen, um seinen Punkt zu sehen; klicken, um ihn zu behalten.</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Korrektur</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>More settings</source>
        <translation>Weitere Einstellungen</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>none: only make the path exact</source>
        <translation>keine: nur die Bahn genau legen</translation>
    </message>
    <message>
        <source>no further part</source>
        <translation>kein weiteres Teil</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>It is right as it is</source>
        <translation>Es ist richtig so</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>keine Zahl</translation>
    </message>
    <message>
        <source>points on the surface (contact)</source>
        <translation>Punkte auf der Oberfläche (Berührpunkte)</translation>
    </message>
    <message>
        <source>centres of the probe's ball</source>
        <translation>Mittelpunkte der Tastkugel</translation>
    </message>
    <message>
        <source>ball centres that the control shifted along an axis</source>
        <translation>Kugelmittelpunkte, die die Steuerung längs einer Achse verschoben hat</translation>
    </message>
    <message>
        <source>mirror: take back what was measured</source>
        <translation>spiegeln: zurücknehmen, was gemessen wurde</translation>
    </message>
    <message>
        <source>transfer: by how the machine gives way</source>
        <translation>Übertragung: danach, wie die Maschine nachgibt</translation>
    </message>
    <message>
        <source>combined: one or two touches, and a model of the machine</source>
        <translation>kombiniert: ein oder zwei Antastungen und ein Modell der Maschine</translation>
    </message>
    <message>
        <source>predicted: by the model alone, before anything is measured</source>
        <translation>vorhergesagt: nach dem Modell allein, bevor etwas gemessen ist</translation>
    </message>
    <message>
        <source>as the operation's</source>
        <translation>wie die der Operation</translation>
    </message>
    <message>
        <source>blue, undercut red</source>
        <translation>blau, Unterschnitt rot</translation>
    </message>
    <message>
        <source>red, undercut blue</source>
        <translation>rot, Unterschnitt blau</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>shift</source>
        <translation>schieben</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>schieben und drehen</translation>
    </message>
    <message>
        <source>none; several separated by ;</source>
        <translation>keine; mehrere durch ; getrennt</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>erwartet</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Mean deviation; positive where material is left</source>
        <translation>Mittlere Abweichung; positiv, wo Material steht</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>Kleinste</translation>
    </message>
    <message>
        <source>Deepest undercut</source>
        <translation>Tiefster Unterschnitt</translation>
    </message>
    <message>
        <source>Greatest</source>
        <translation>Größte</translation>
    </message>
    <message>
        <source>Most material left</source>
        <translation>Am meisten stehendes Material</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Spanne</translation>
    </message>
    <message>
        <source>Greatest less least</source>
        <translation>Größte weniger kleinste</translation>
    </message>
    <message>
        <source>Std. dev.</source>
        <translation>Std.-Abw.</translation>
    </message>
    <message>
        <source>Spread of deviations about their mean</source>
        <translation>Streuung der Abweichungen um ihr Mittel</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Standard deviation of what does not repeat and is therefore not corrected</source>
        <translation>Standardabweichung dessen, was sich nicht wiederholt und darum nicht korrigiert wird</translation>
    </message>
    <message>
        <source>Largest correction</source>
        <translation>Größte Korrektur</translation>
    </message>
    <message>
        <source>Farthest that the profile to cut lies from the nominal</source>
        <translation>Wie weit das zu fräsende Profil höchstens von der Sollkontur liegt</translation>
    </message>
    <message>
        <source>Path error before</source>
        <translation>Bahnfehler vorher</translation>
    </message>
    <message>
        <source>How far the operation's own path is off the exact one</source>
        <translation>Wie weit die Bahn der Operation von der genauen abweicht</translation>
    </message>
    <message>
        <source>Path error after</source>
        <translation>Bahnfehler nachher</translation>
    </message>
    <message>
        <source>How far the corrected path is off the exact one, read back from the finished path</source>
        <translation>Wie weit die korrigierte Bahn von der genauen abweicht, aus der fertigen Bahn zurückgelesen</translation>
    </message>
    <message>
        <source>Points used</source>
        <translation>Benutzte Punkte</translation>
    </message>
    <message>
        <source>Points used, of those in the file</source>
        <translation>Benutzte Punkte, von denen in der Datei</translation>
    </message>
    <message>
        <source>Points left out</source>
        <translation>Ausgelassene Punkte</translation>
    </message>
    <message>
        <source>Each is marked in the picture, with its reason</source>
        <translation>Jeder ist im Bild bezeichnet, mit dem Grund</translation>
    </message>
    <message>
        <source>Settings (*.toml);;All files (*)</source>
        <translation>Einstellungen (*.toml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>nicht benutzt</translation>
    </message>
    <message>
        <source>no file yet</source>
        <translation>noch keine Datei</translation>
    </message>
    <message>
        <source>Meaning of column {}</source>
        <translation>Bedeutung der Spalte {}</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Stopped; nothing was written</source>
        <translation>Angehalten; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>Needs: {}</source>
        <translation>Es fehlt: {}</translation>
    </message>
    <message>
        <source>More in the documentation</source>
        <translation>Mehr in der Dokumentation</translation>
    </message>
    <message>
        <source>Millcorr help</source>
        <translation>Hilfe zu Millcorr</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Import measurement</source>
        <translation>Messung importieren</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>file of a CMM, a probe log, or a table of points</source>
        <translation>Datei einer Messmaschine, ein Tasterprotokoll oder eine Tabelle von Punkten</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>&amp;More</source>
        <translation>&amp;Mehr</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>by its content</source>
        <translation>nach dem Inhalt</translation>
    </message>
    <message>
        <source>Points: {}, heights: {}. {} {}. Format: {}, unit in the file: {}</source>
        <translation>Punkte: {}, Höhen: {}. {} {}. Format: {}, Einheit in der Datei: {}</translation>
    </message>
    <message>
        <source>Not imported, see the report view</source>
        <translation>Nicht importiert, siehe Berichtsansicht</translation>
    </message>
    <message>
        <source>Origin of the work frame in the file's, {}</source>
        <translation>Nullpunkt des Werkstücksystems im System der Datei, {}</translation>
    </message>
    <message>
        <source>nominal profile</source>
        <translation>Sollprofil</translation>
    </message>
    <message>
        <source>profile to cut</source>
        <translation>zu fräsendes Profil</translation>
    </message>
    <message>
        <source>tolerance band</source>
        <translation>Toleranzband</translation>
    </message>
    <message>
        <source>path before</source>
        <translation>Bahn vorher</translation>
    </message>
    <message>
        <source>corrected path</source>
        <translation>korrigierte Bahn</translation>
    </message>
    <message>
        <source>points left out</source>
        <translation>ausgelassene Punkte</translation>
    </message>
    <message>
        <source>in tolerance</source>
        <translation>in der Toleranz</translation>
    </message>
    <message>
        <source>material left</source>
        <translation>Material steht</translation>
    </message>
    <message>
        <source>undercut</source>
        <translation>Unterschnitt</translation>
    </message>
    <message>
        <source>Deviations {}:1</source>
        <translation>Abweichungen {}:1</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>selbsttätig</translation>
    </message>
    <message>
        <source>no points near</source>
        <translation>keine Punkte in der Nähe</translation>
    </message>
    <message>
        <source>the largest possible</source>
        <translation>die größtmögliche</translation>
    </message>
    <message>
        <source>(the largest of every {})</source>
        <translation>(die größten von je {})</translation>
    </message>
    <message>
        <source>Drawn at {:.4g}:1: more would turn the contour inside out.</source>
        <translation>Mit {:.4g}:1 gezeichnet: mehr würde die Kontur umstülpen.</translation>
    </message>
    <message>
        <source>Run in LinuxCNC's own interpreter. Moves between touches are unprotected.</source>
        <translation>Lief in LinuxCNCs eigenem Interpreter. Wege zwischen den Antastungen sind ungeschützt.</translation>
    </message>
    <message>
        <source>Run in LinuxCNC's own interpreter. Moves between touches stop at contact. Prefer it.</source>
        <translation>Lief in LinuxCNCs eigenem Interpreter. Wege zwischen den Antastungen halten bei Berührung an. Vorzuziehen.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after GRBL's documentation. Moves between touches are unprotected.</source>
        <translation>Lief in einem Interpreter nach der Dokumentation von GRBL. Wege zwischen den Antastungen sind ungeschützt.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after Renishaw's description of its cycles; result variables compared with public tables.</source>
        <translation>Lief in einem Interpreter nach Renishaws Beschreibung der Zyklen; Ergebnisvariablen mit öffentlichen Tabellen verglichen.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after public descriptions. No manual with the names of the arguments was at hand: compare with yours.</source>
        <translation>Lief in einem Interpreter nach öffentlichen Beschreibungen. Ein Handbuch mit den Namen der Argumente lag nicht vor: mit dem eigenen vergleichen.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after the description of TCH PROBE cycle 3.</source>
        <translation>Lief in einem Interpreter nach der Beschreibung von TCH PROBE Zyklus 3.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after the programming manual of MEAS.</source>
        <translation>Lief in einem Interpreter nach dem Programmierhandbuch von MEAS.</translation>
    </message>
    <message>
        <source>Write program</source>
        <translation>Programm schreiben</translation>
    </message>
    <message>
        <source>by their distance</source>
        <translation>nach ihrem Abstand</translation>
    </message>
    <message>
        <source>by their number</source>
        <translation>nach ihrer Anzahl</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>überall</translation>
    </message>
    <message>
        <source>it is in use</source>
        <translation>er ist im Einsatz</translation>
    </message>
    <message>
        <source>Measuring program</source>
        <translation>Messprogramm</translation>
    </message>
    <message>
        <source>No program of millcorr has run on a real machine. Run the first one above the part, then with the feed override low and a hand on feed hold.</source>
        <translation>Kein Programm von millcorr ist je auf einer wirklichen Maschine gelaufen. Das erste über dem Teil fahren, dann mit kleinem Vorschub-Override und der Hand am Vorschub-Halt.</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>Probe and points on {}</source>
        <translation>Taster und Punkte auf {}</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bezugssystem</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>angegeben</translation>
    </message>
    <message>
        <source>said</source>
        <translation>von Ihnen gesagt</translation>
    </message>
    <message>
        <source>inferred</source>
        <translation>erschlossen</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>Millcorr needs Python packages that FreeCAD's Python does not have: {}.

They can be installed into {}, for FreeCAD alone, from the network.</source>
        <translation>Millcorr braucht Python-Pakete, die FreeCADs Python nicht hat: {}.

Sie lassen sich aus dem Netz nach {} installieren, für FreeCAD allein.</translation>
    </message>
    <message>
        <source>They could not be installed: {}

In a terminal, this does the same:
{}</source>
        <translation>Sie ließen sich nicht installieren: {}

In einem Terminal tut dies dasselbe:
{}</translation>
    </message>
    <message>
        <source>Python packages, which a dialog offers to install: {}</source>
        <translation>Python-Pakete, die ein Fenster zu installieren anbietet: {}</translation>
    </message>
    <message>
        <source>Install</source>
        <translation>Installieren</translation>
    </message>
    <message>
        <source>Installing…</source>
        <translation>Wird installiert…</translation>
    </message>
    <message>
        <source>Installed. Start FreeCAD again to use them.</source>
        <translation>Installiert. Starten Sie FreeCAD neu, um sie zu verwenden.</translation>
    </message>
    <message>
        <source>On Debian and Ubuntu pip comes with: apt install python3-pip</source>
        <translation>Unter Debian und Ubuntu kommt pip mit: apt install python3-pip</translation>
    </message>
    <message>
        <source>Stopped: change a setting to compute again</source>
        <translation>Angehalten: eine Einstellung ändern, um neu zu rechnen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Rechnen</translation>
    </message>
    <message>
        <source>Internal error, see the report view</source>
        <translation>Interner Fehler, siehe Berichtsansicht</translation>
    </message>
    <message>
        <source>Close the open task first</source>
        <translation>Erst die offene Aufgabe schließen</translation>
    </message>
    <message>
        <source>Not possible yet: see {}</source>
        <translation>Noch nicht möglich: siehe {}</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>blau</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rot</translation>
    </message>
    <message>
        <source>expected next</source>
        <translation>beim nächsten erwartet</translation>
    </message>
    <message>
        <source>range of the points</source>
        <translation>Bereich der Punkte</translation>
    </message>
    <message>
        <source>mean and standard deviation</source>
        <translation>Mittel und Standardabweichung</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>program corrected</source>
        <translation>Programm korrigiert</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>Ausreißer</translation>
    </message>
    <message>
        <source>normal law of the scatter</source>
        <translation>Normalverteilung der Streuung</translation>
    </message>
    <message>
        <source>part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>arc length s, {}</source>
        <translation>Bogenlänge s, {}</translation>
    </message>
    <message>
        <source>uncertainty, k = {:g}</source>
        <translation>Unsicherheit, k = {:g}</translation>
    </message>
    <message>
        <source>determined part</source>
        <translation>bestimmter Anteil</translation>
    </message>
    <message>
        <source>form, root mean square</source>
        <translation>Form, quadratischer Mittelwert</translation>
    </message>
    <message>
        <source>smoothed, largest</source>
        <translation>geglättet, größte</translation>
    </message>
    <message>
        <source>deviation, {}</source>
        <translation>Abweichung, {}</translation>
    </message>
    <message>
        <source>Click at a place of the picture or the plot to see its line of the file.</source>
        <translation>Auf eine Stelle des Bildes oder der Kurve klicken, um ihre Zeile der Datei zu sehen.</translation>
    </message>
    <message>
        <source>The measured file is no plain text.</source>
        <translation>Die Messdatei ist kein reiner Text.</translation>
    </message>
    <message>
        <source>s {0:.{1}f} {2}: measured {3} {5}, expected next {4} {5}</source>
        <translation>s {0:.{1}f} {2}: gemessen {3} {5}, beim nächsten erwartet {4} {5}</translation>
    </message>
    <message>
        <source>Millcorr plots</source>
        <translation>Millcorr-Diagramme</translation>
    </message>
    <message>
        <source>Linked to the 3-D view</source>
        <translation>Mit der 3D-Ansicht verbunden</translation>
    </message>
    <message>
        <source>What is pointed at in the plot shows in the 3-D view and the other way round; the view follows the zoom of the plot, the plot that of the view</source>
        <translation>Worauf im Diagramm gezeigt wird, erscheint in der 3D-Ansicht und umgekehrt; die Ansicht folgt dem Zoom des Diagramms, das Diagramm dem der Ansicht</translation>
    </message>
    <message>
        <source>Measured file</source>
        <translation>Messdatei</translation>
    </message>
    <message>
        <source>Select a compensated toolpath</source>
        <translation>Eine korrigierte Bahn wählen</translation>
    </message>
    <message>
        <source>A journal's parts are plotted from the window History of parts</source>
        <translation>Die Teile eines Journals zeichnet das Fenster Verlauf der Teile</translation>
    </message>
    <message>
        <source>Along the contour</source>
        <translation>Längs der Kontur</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>The journal has no part yet</source>
        <translation>Das Journal hat noch kein Teil</translation>
    </message>
    <message>
        <source>{}, parts: {}</source>
        <translation>{}, Teile: {}</translation>
    </message>
    <message>
        <source>{}: nothing was measured</source>
        <translation>{}: nichts wurde gemessen</translation>
    </message>
    <message>
        <source>NC programs (*.nc *.ngc *.tap *.gcode *.cnc *.mpf *.h *.txt);;All files (*)</source>
        <translation>NC-Programme (*.nc *.ngc *.tap *.gcode *.cnc *.mpf *.h *.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Contours (*.step *.stp *.iges *.igs *.brep *.dxf *.json *.nc *.ngc *.tap *.gcode *.cnc *.mpf);;All files (*)</source>
        <translation>Konturen (*.step *.stp *.iges *.igs *.brep *.dxf *.json *.nc *.ngc *.tap *.gcode *.cnc *.mpf);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Correct NC program file</source>
        <translation>NC-Programmdatei korrigieren</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>How the file is read</source>
        <translation>Wie die Datei gelesen wird</translation>
    </message>
    <message>
        <source>What is written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message>
        <source>Split allowance</source>
        <translation>Aufmaß teilen</translation>
    </message>
    <message>
        <source>The first cut leaves a part of the allowance. Measure it, then correct the program that finishes the part with the method “transfer”: the part itself has shown how far the machine yields.</source>
        <translation>Der erste Schnitt lässt einen Teil des Aufmaßes stehen. Ihn messen, dann das Programm, das das Teil fertig fräst, mit dem Verfahren „Übertragung“ korrigieren: das Teil selbst hat gezeigt, wie weit die Maschine nachgibt.</translation>
    </message>
    <message>
        <source>The program of the first cut is written</source>
        <translation>Das Programm des ersten Schnitts ist geschrieben</translation>
    </message>
    <message>
        <source>Deviations, {}</source>
        <translation>Abweichungen, {}</translation>
    </message>
    <message>
        <source>Set {} to {}</source>
        <translation>{} auf {} setzen</translation>
    </message>
    <message>
        <source>Go to {}</source>
        <translation>Zu {} gehen</translation>
    </message>
    <message>
        <source>Switch on {}</source>
        <translation>{} einschalten</translation>
    </message>
    <message>
        <source>an operation selected in the tree</source>
        <translation>eine im Baum gewählte Operation</translation>
    </message>
    <message>
        <source>a compensated toolpath: make one first</source>
        <translation>eine korrigierte Bahn: zuerst eine machen</translation>
    </message>
    <message>
        <source>an open document</source>
        <translation>ein offenes Dokument</translation>
    </message>
    <message>
        <source>a job with an operation, such as a Profile</source>
        <translation>ein Auftrag mit einer Operation, etwa einem Profil</translation>
    </message>
    <message>
        <source>an operation that stands in a job, without a dressup over it: select the dressup</source>
        <translation>eine Operation, die in einem Auftrag steht, ohne Dressup darüber: das Dressup wählen</translation>
    </message>
    <message>
        <source>a compensated toolpath selected in the tree</source>
        <translation>eine im Baum gewählte korrigierte Bahn</translation>
    </message>
    <message>
        <source>a compensated toolpath with a measured part</source>
        <translation>eine korrigierte Bahn mit einem gemessenen Teil</translation>
    </message>
    <message>
        <source>a Profile operation with a path, selected in the tree</source>
        <translation>eine im Baum gewählte Profil-Operation mit einer Bahn</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>engaged arc</source>
        <translation>Eingriffswinkel</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>deflection</source>
        <translation>Auslenkung</translation>
    </message>
    <message>
        <source>Setups (*.toml);;All files (*)</source>
        <translation>Einrichtungen (*.toml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Name the setup: tool, material, machine and stock, as a TOML file.</source>
        <translation>Die Einrichtung nennen: Werkzeug, Werkstoff, Maschine und Rohteil, als TOML-Datei.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>So many times faster than the machine</source>
        <translation>So viel schneller als die Maschine</translation>
    </message>
    <message>
        <source>Largest predicted error {} {}</source>
        <translation>Größter vorhergesagter Fehler {} {}</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>{:.2f} s, line {}: </source>
        <translation>{:.2f} s, Zeile {}: </translation>
    </message>
    <message>
        <source>, corrected {} {}</source>
        <translation>, korrigiert {} {}</translation>
    </message>
    <message>
        <source>&lt;span style='color:#888'&gt;—&lt;/span&gt; commanded path, &lt;span style='color:#c00'&gt;—&lt;/span&gt; machined contour, &lt;span style='color:#2e9a1c'&gt;—&lt;/span&gt; corrected contour, errors {:g}:1</source>
        <translation>&lt;span style='color:#888'&gt;—&lt;/span&gt; befohlene Bahn, &lt;span style='color:#c00'&gt;—&lt;/span&gt; gefräste Kontur, &lt;span style='color:#2e9a1c'&gt;—&lt;/span&gt; korrigierte Kontur, Fehler {:g}:1</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Open {}</source>
        <translation>{} öffnen</translation>
    </message>
    <message>
        <source>Constant offset</source>
        <translation>Fester Versatz</translation>
    </message>
    <message>
        <source>What stays whatever the depth, such as a wrong tool radius; known from two depths only</source>
        <translation>Was bei jeder Tiefe bleibt, etwa ein falscher Werkzeugradius; nur aus zwei Tiefen bekannt</translation>
    </message>
    <message>
        <source>MS, mean</source>
        <translation>MS, Mittel</translation>
    </message>
    <message>
        <source>Share of the depth removed that the machine yields</source>
        <translation>Anteil der abgenommenen Tiefe, um den die Maschine nachgibt</translation>
    </message>
    <message>
        <source>MS, least</source>
        <translation>MS, kleinste</translation>
    </message>
    <message>
        <source>Where the machine is stiffest</source>
        <translation>Wo die Maschine am steifsten ist</translation>
    </message>
    <message>
        <source>MS, greatest</source>
        <translation>MS, größte</translation>
    </message>
    <message>
        <source>Where the machine yields most</source>
        <translation>Wo die Maschine am meisten nachgibt</translation>
    </message>
    <message>
        <source>Uncertainty of MS</source>
        <translation>Unsicherheit von MS</translation>
    </message>
    <message>
        <source>Standard uncertainty at a point</source>
        <translation>Standardunsicherheit an einem Punkt</translation>
    </message>
    <message>
        <source>Next depth</source>
        <translation>Nächste Tiefe</translation>
    </message>
    <message>
        <source>Depth that the corrected path will find</source>
        <translation>Tiefe, die die korrigierte Bahn vorfindet</translation>
    </message>
    <message>
        <source>Uncertainty of the correction</source>
        <translation>Unsicherheit der Korrektur</translation>
    </message>
    <message>
        <source>Standard uncertainty of where the path is put</source>
        <translation>Standardunsicherheit dessen, wohin die Bahn gelegt wird</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Übertragungsfunktion</translation>
    </message>
    <message>
        <source>The machine yields in proportion to what it cuts. From the depth H of the measured part and its error δ follows the transfer function &lt;b&gt;MS = δ / (H − δ)&lt;/b&gt;; the next path commands &lt;b&gt;H · (1 + MS)&lt;/b&gt;, and removes H. That also holds at another depth, where a mirrored error does not.</source>
        <translation>Die Maschine gibt im Verhältnis zu dem nach, was sie abnimmt. Aus der Tiefe H des gemessenen Teils und seinem Fehler δ folgt die Übertragungsfunktion &lt;b&gt;MS = δ / (H − δ)&lt;/b&gt;; die nächste Bahn befiehlt &lt;b&gt;H · (1 + MS)&lt;/b&gt; und nimmt H ab. Das gilt auch bei anderer Tiefe, wo ein gespiegelter Fehler nicht stimmt.</translation>
    </message>
    <message>
        <source>Depths</source>
        <translation>Tiefen</translation>
    </message>
    <message>
        <source>Machining system</source>
        <translation>Bearbeitungssystem</translation>
    </message>
    <message>
        <source>The first cut leaves a part of the allowance on the finished contour. Measure the part then, import the measurement, and correct with the transfer function: the second cut comes out right.</source>
        <translation>Der erste Schnitt lässt einen Teil des Aufmaßes auf der fertigen Kontur stehen. Dann das Teil messen, die Messung importieren und mit der Übertragungsfunktion korrigieren: der zweite Schnitt stimmt.</translation>
    </message>
    <message>
        <source>A program file instead…</source>
        <translation>Stattdessen eine Programmdatei…</translation>
    </message>
    <message>
        <source>The first cut takes {0} {2} and leaves {1} {2}. Its path is within {3} {4} of the exact parallel.</source>
        <translation>Der erste Schnitt nimmt {0} {2} und lässt {1} {2}. Seine Bahn ist bis auf {3} {4} die genaue Parallele.</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>New corrections</source>
        <translation>Neue Korrekturen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>What separates form from scatter: none, mean:5, mean:1,2,3,2,1, gauss:MM or auto</source>
        <translation>Was Form von Streuung trennt: none, mean:5, mean:1,2,3,2,1, gauss:MM oder auto</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Share of the deviation taken back</source>
        <translation>Anteil der Abweichung, der zurückgenommen wird</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Largest correction; a larger one is refused</source>
        <translation>Größte Korrektur; eine größere wird verweigert</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Totband</translation>
    </message>
    <message>
        <source>Deviations up to this are left alone</source>
        <translation>Abweichungen bis hierher bleiben unberührt</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Largest distance of the path from the exact one</source>
        <translation>Größter Abstand der Bahn von der genauen</translation>
    </message>
    <message>
        <source>New measurements</source>
        <translation>Neue Messungen</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>What the coordinates of a measured file are</source>
        <translation>Was die Koordinaten einer Messdatei sind</translation>
    </message>
    <message>
        <source>Ball radius</source>
        <translation>Kugelradius</translation>
    </message>
    <message>
        <source>Radius of the probe's ball; 0: as the file says</source>
        <translation>Radius der Tastkugel; 0: wie die Datei sagt</translation>
    </message>
    <message>
        <source>Measuring programs</source>
        <translation>Messprogramme</translation>
    </message>
    <message>
        <source>Control that runs measuring programs</source>
        <translation>Steuerung, auf der Messprogramme laufen</translation>
    </message>
    <message>
        <source>Touch feed</source>
        <translation>Antastvorschub</translation>
    </message>
    <message>
        <source>Feed of the touch</source>
        <translation>Vorschub der Antastung</translation>
    </message>
    <message>
        <source>Positioning feed</source>
        <translation>Positioniervorschub</translation>
    </message>
    <message>
        <source>Feed of moves at measuring height</source>
        <translation>Vorschub der Wege in Messhöhe</translation>
    </message>
    <message>
        <source>Pictures and plots</source>
        <translation>Bilder und Diagramme</translation>
    </message>
    <message>
        <source>Show the deviations in the 3-D view as soon as a correction is made</source>
        <translation>Zeigt die Abweichungen in der 3D-Ansicht, sobald eine Korrektur gemacht ist</translation>
    </message>
    <message>
        <source>Show the deviations of a new correction</source>
        <translation>Die Abweichungen einer neuen Korrektur zeigen</translation>
    </message>
    <message>
        <source>Deviations and the part's size decide how much larger deviations are drawn</source>
        <translation>Abweichungen und Größe des Teils entscheiden, wie viel größer Abweichungen gezeichnet werden</translation>
    </message>
    <message>
        <source>Automatic magnification</source>
        <translation>Selbsttätige Vergrößerung</translation>
    </message>
    <message>
        <source>Magnification</source>
        <translation>Vergrößerung</translation>
    </message>
    <message>
        <source>So many times longer than they are deviations are drawn</source>
        <translation>So viel länger als sie sind werden Abweichungen gezeichnet</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Oberes Abmaß</translation>
    </message>
    <message>
        <source>Larger deviations are out of tolerance: too much material is left</source>
        <translation>Größere Abweichungen liegen außerhalb der Toleranz: zu viel Material steht</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Unteres Abmaß</translation>
    </message>
    <message>
        <source>Smaller deviations are out of tolerance: too much is cut away</source>
        <translation>Kleinere Abweichungen liegen außerhalb der Toleranz: zu viel ist weggeschnitten</translation>
    </message>
    <message>
        <source>Material left</source>
        <translation>Stehendes Material</translation>
    </message>
    <message>
        <source>Colour of material left; measuring machines' programs show it red</source>
        <translation>Farbe stehenden Materials; Programme von Messmaschinen zeigen es rot</translation>
    </message>
    <message>
        <source>Colours of plots</source>
        <translation>Farben der Diagramme</translation>
    </message>
    <message>
        <source>Light or dark plots</source>
        <translation>Helle oder dunkle Diagramme</translation>
    </message>
    <message>
        <source>as the window</source>
        <translation>wie das Fenster</translation>
    </message>
    <message>
        <source>light</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
</context>
<context>
    <name>Millcorr_Report</name>
    <message>
        <source>Directory for the report</source>
        <translation>Verzeichnis für den Bericht</translation>
    </message>
    <message>
        <source>Export report…</source>
        <translation>Bericht ausgeben…</translation>
    </message>
    <message>
        <source>Write the report of the selected compensated toolpath to a directory</source>
        <translation>Schreibt den Bericht der gewählten korrigierten Bahn in ein Verzeichnis</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>Bericht ausgeben</translation>
    </message>
</context>
<context>
    <name>Millcorr_Profile</name>
    <message>
        <source>Compensated profile</source>
        <translation>Korrigiertes Profil</translation>
    </message>
    <message>
        <source>Make the profile to cut, as a NURBS for any operation</source>
        <translation>Macht das zu fräsende Profil, als NURBS für jede Operation</translation>
    </message>
</context>
<context>
    <name>Millcorr_Measurement</name>
    <message>
        <source>Import measurement…</source>
        <translation>Messung importieren…</translation>
    </message>
    <message>
        <source>Read the measured points of a part and keep the file in the document</source>
        <translation>Liest die Messpunkte eines Teils und bewahrt die Datei im Dokument auf</translation>
    </message>
</context>
<context>
    <name>Millcorr_Dressup</name>
    <message>
        <source>Compensated toolpath…</source>
        <translation>Korrigierte Bahn…</translation>
    </message>
    <message>
        <source>Correct the path of the selected operation from a measured part</source>
        <translation>Korrigiert die Bahn der gewählten Operation nach einem gemessenen Teil</translation>
    </message>
</context>
<context>
    <name>Millcorr_Picture</name>
    <message>
        <source>Show deviations</source>
        <translation>Abweichungen zeigen</translation>
    </message>
    <message>
        <source>Show or hide deviations, profiles and paths of the selected compensated toolpath</source>
        <translation>Zeigt oder verbirgt Abweichungen, Profile und Bahnen der gewählten korrigierten Bahn</translation>
    </message>
</context>
<context>
    <name>Millcorr_Transfer</name>
    <message>
        <source>Transfer function…</source>
        <translation>Übertragungsfunktion…</translation>
    </message>
    <message>
        <source>Correct by how far the machine yields, from the depth that was cut</source>
        <translation>Korrigiert danach, wie weit die Maschine nachgibt, aus der gefrästen Tiefe</translation>
    </message>
</context>
<context>
    <name>Millcorr_Split</name>
    <message>
        <source>Split allowance…</source>
        <translation>Aufmaß teilen…</translation>
    </message>
    <message>
        <source>Cut an allowance in two: measure after the first cut, correct the second</source>
        <translation>Teilt ein Aufmaß in zwei Schnitte: nach dem ersten messen, den zweiten korrigieren</translation>
    </message>
</context>
<context>
    <name>Millcorr_Probe</name>
    <message>
        <source>Measuring program…</source>
        <translation>Messprogramm…</translation>
    </message>
    <message>
        <source>Write a program that measures the selected operation's contour on the machine</source>
        <translation>Schreibt ein Programm, das die Kontur der gewählten Operation auf der Maschine misst</translation>
    </message>
</context>
<context>
    <name>Millcorr_Plots</name>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Deviations along the contour and their distribution, linked to the 3-D view</source>
        <translation>Abweichungen längs der Kontur und ihre Verteilung, mit der 3D-Ansicht verbunden</translation>
    </message>
</context>
<context>
    <name>Millcorr_Simulate</name>
    <message>
        <source>Simulate…</source>
        <translation>Simulieren…</translation>
    </message>
    <message>
        <source>Run the cutter along the selected operation: force, deflection, predicted contour</source>
        <translation>Lässt den Fräser die gewählte Operation abfahren: Kraft, Auslenkung, vorhergesagte Kontur</translation>
    </message>
</context>
<context>
    <name>Millcorr_Program</name>
    <message>
        <source>Correct NC program file…</source>
        <translation>NC-Programmdatei korrigieren…</translation>
    </message>
    <message>
        <source>Correct an NC program from a measured part, without any document</source>
        <translation>Korrigiert ein NC-Programm nach einem gemessenen Teil, ohne ein Dokument</translation>
    </message>
</context>
<context>
    <name>Millcorr_Batch</name>
    <message>
        <source>Batch…</source>
        <translation>Stapel…</translation>
    </message>
    <message>
        <source>Run many corrections from one file, in the background</source>
        <translation>Führt viele Korrekturen aus einer Datei im Hintergrund aus</translation>
    </message>
</context>
<context>
    <name>Millcorr_History</name>
    <message>
        <source>History of parts…</source>
        <translation>Verlauf der Teile…</translation>
    </message>
    <message>
        <source>Show what the journal of a series holds: parts, corrections, trends</source>
        <translation>Zeigt, was das Journal einer Serie enthält: Teile, Korrekturen, Trends</translation>
    </message>
</context>
<context>
    <name>Millcorr_Help</name>
    <message>
        <source>Millcorr help</source>
        <translation>Hilfe zu Millcorr</translation>
    </message>
    <message>
        <source>The documentation, page by page</source>
        <translation>Die Dokumentation, Seite für Seite</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Millcorr</source>
        <translation>Millcorr</translation>
    </message>
    <message>
        <source>Correct milling toolpaths from measured parts</source>
        <translation>Fräsbahnen nach gemessenen Teilen korrigieren</translation>
    </message>
    <message>
        <source>Macros</source>
        <translation>Makros</translation>
    </message>
</context>
<context>
    <name>Millcorr_Macro</name>
    <message>
        <source>Correct document</source>
        <translation>Dokument korrigieren</translation>
    </message>
    <message>
        <source>Ask for a document and a measured file; write the corrected document, its program and the report beside it</source>
        <translation>Fragt nach einem Dokument und einer Messdatei; schreibt das korrigierte Dokument, sein Programm und den Bericht daneben</translation>
    </message>
    <message>
        <source>Correct selected operation</source>
        <translation>Gewählte Operation korrigieren</translation>
    </message>
    <message>
        <source>Ask for a measured file and correct the selected operation, or the job's only Profile, with it</source>
        <translation>Fragt nach einer Messdatei und korrigiert damit die gewählte Operation oder das einzige Profil des Auftrags</translation>
    </message>
    <message>
        <source>Measuring program for LinuxCNC</source>
        <translation>Messprogramm für LinuxCNC</translation>
    </message>
    <message>
        <source>Ask for a file and write a measuring program of the selected operation, or of the job's only Profile</source>
        <translation>Fragt nach einer Datei und schreibt ein Messprogramm der gewählten Operation oder des einzigen Profils im Auftrag</translation>
    </message>
</context>
<context>
    <name>Millcorr_Said</name>
    <message>
        <source>{}: {} {} puts the path on the other side of the contour</source>
        <translation>{}: {} {} legt die Bahn auf die andere Seite der Kontur</translation>
    </message>
    <message>
        <source>{}: the operation's base geometry gives no profile; select faces or edges of it in the operation, with processPerimeter or processHoles on</source>
        <translation>{}: die Basisgeometrie der Operation ergibt kein Profil; wählen Sie in der Operation Flächen oder Kanten, mit processPerimeter oder processHoles</translation>
    </message>
    <message>
        <source>{}: lines of the pattern {} end on the pocket's walls, and would cut into them once they are corrected; choose the pattern Offset</source>
        <translation>{}: Linien des Musters {} enden an den Wänden der Tasche und würden nach der Korrektur in sie schneiden; wählen Sie das Muster Offset</translation>
    </message>
    <message>
        <source>{}: the operation belongs to no job and has no base geometry</source>
        <translation>{}: die Operation gehört zu keinem Auftrag und hat keine Basisgeometrie</translation>
    </message>
    <message>
        <source>{}: the job has no model</source>
        <translation>{}: der Auftrag hat kein Modell</translation>
    </message>
    <message>
        <source>{}: set {} to 0, the control holds the radius (UseComp off)</source>
        <translation>{}: setzen Sie {} auf 0, die Steuerung hält den Radius (UseComp aus)</translation>
    </message>
    <message>
        <source>{}: a pocket follows faces, and an edge of {} is selected</source>
        <translation>{}: eine Tasche folgt Flächen, und gewählt ist eine Kante von {}</translation>
    </message>
    <message>
        <source>{}: {}.{} is neither face nor edge</source>
        <translation>{}: {}.{} ist weder Fläche noch Kante</translation>
    </message>
    <message>
        <source>{}: {}.{} is neither level nor vertical; choose a sketch of the contour as Nominal</source>
        <translation>{}: {}.{} ist weder waagrecht noch senkrecht; wählen Sie eine Skizze der Kontur als Sollkontur</translation>
    </message>
    <message>
        <source>Profile operations</source>
        <translation>Profiloperationen</translation>
    </message>
    <message>
        <source>operations called {}</source>
        <translation>Operationen namens {}</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>the document has {} {}; its operations are: {}</source>
        <translation>das Dokument hat {} {}; seine Operationen sind: {}</translation>
    </message>
    <message>
        <source>{} belongs to a document that is a file, and to an {}: it records both</source>
        <translation>{} gehört zu einem Dokument, das eine Datei ist, und zu {}: es hält beide fest</translation>
    </message>
    <message>
        <source>{}: FreeCAD could not recompute the corrected path</source>
        <translation>{}: FreeCAD konnte die korrigierte Bahn nicht neu berechnen</translation>
    </message>
    <message>
        <source>{}: the posted program has no move of this operation</source>
        <translation>{}: das ausgegebene Programm enthält keine Bewegung dieser Operation</translation>
    </message>
    <message>
        <source>The path error is that of the path itself: the job's post processor gave no program ({}).</source>
        <translation>Der Bahnfehler ist der der Bahn selbst: der Postprozessor des Auftrags ergab kein Programm ({}).</translation>
    </message>
    <message>
        <source>no</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>a setting is not possible: {}</source>
        <translation>eine Einstellung ist nicht möglich: {}</translation>
    </message>
    <message>
        <source>FreeCAD's post processor {} does not write the path as it is: {}; post with another one</source>
        <translation>FreeCADs Postprozessor {} schreibt die Bahn nicht so, wie sie ist: {}; geben Sie mit einem anderen aus</translation>
    </message>
    <message>
        <source>what FreeCAD's post processor {} makes is no G-code that can be read back and proven ({}{}): choose a post processor of G-code in the job, as linuxcnc or grbl</source>
        <translation>was FreeCADs Postprozessor {} erzeugt, ist kein G-Code, der zurückgelesen und geprüft werden kann ({}{}): wählen Sie im Auftrag einen Postprozessor für G-Code, etwa linuxcnc oder grbl</translation>
    </message>
    <message>
        <source>{}: the operation has no tool with a diameter; set ToolDiameter</source>
        <translation>{}: die Operation hat kein Werkzeug mit Durchmesser; geben Sie den Werkzeugdurchmesser an</translation>
    </message>
    <message>
        <source>{}: the tool's diameter is {}; set ToolDiameter</source>
        <translation>{}: der Werkzeugdurchmesser ist {}; geben Sie den Werkzeugdurchmesser an</translation>
    </message>
    <message>
        <source>{} has no shape to take as nominal profile</source>
        <translation>{} hat keine Form, die als Nennprofil dienen kann</translation>
    </message>
    <message>
        <source>{}: FreeCAD's post processor {} made no program</source>
        <translation>{}: FreeCADs Postprozessor {} ergab kein Programm</translation>
    </message>
    <message>
        <source>{}: FreeCAD's post processor made {} programs; clear SplitOutput</source>
        <translation>{}: FreeCADs Postprozessor ergab {} Programme; schalten Sie SplitOutput aus</translation>
    </message>
    <message>
        <source>the dressups of {} form a ring</source>
        <translation>die Aufbereitungen von {} bilden einen Ring</translation>
    </message>
    <message>
        <source>{}: FreeCAD's own post processor {} fails on this job ({}): post with another one</source>
        <translation>{}: FreeCADs eigener Postprozessor {} scheitert an diesem Auftrag ({}): geben Sie mit einem anderen aus</translation>
    </message>
    <message>
        <source>a profile lies parallel to the XY plane: choose level edges, upright faces, or a sketch of it as Nominal</source>
        <translation>ein Profil liegt parallel zur XY-Ebene: wählen Sie waagrechte Kanten, senkrechte Flächen oder eine Skizze davon als Sollkontur</translation>
    </message>
    <message>
        <source>select the faces or edges of the profile in the operation, or choose a sketch of it as Nominal</source>
        <translation>wählen Sie in der Operation die Flächen oder Kanten des Profils, oder eine Skizze davon als Sollkontur</translation>
    </message>
    <message>
        <source>a side face near {} ends neither below nor above in level edges alone: choose a sketch or level edges of the contour as Nominal</source>
        <translation>eine Seitenfläche nahe {} endet weder unten noch oben nur in waagrechten Kanten: wählen Sie eine Skizze oder waagrechte Kanten der Kontur als Sollkontur</translation>
    </message>
    <message>
        <source>an edge of the profile has no length</source>
        <translation>eine Kante des Profils hat keine Länge</translation>
    </message>
    <message>
        <source>an edge near {} is not level: it runs from Z{:.6f} to Z{:.6f}; {}</source>
        <translation>eine Kante nahe {} ist nicht waagrecht: sie läuft von Z{:.6f} bis Z{:.6f}; {}</translation>
    </message>
    <message>
        <source>an edge near {} is not level: its poles differ by {} in Z; {}</source>
        <translation>eine Kante nahe {} ist nicht waagrecht: ihre Kontrollpunkte liegen in Z um {} auseinander; {}</translation>
    </message>
    <message>
        <source>the profile has no edge</source>
        <translation>das Profil hat keine Kante</translation>
    </message>
    <message>
        <source>the shape of the profile is empty</source>
        <translation>die Form des Profils ist leer</translation>
    </message>
    <message>
        <source>a face of the profile is not parallel to the XY plane, and the faces close round no solid: choose a sketch or level edges of the contour as Nominal, or save the model as STEP</source>
        <translation>eine Fläche des Profils liegt nicht parallel zur XY-Ebene, und die Flächen schließen keinen Körper ein: wählen Sie eine Skizze oder waagrechte Kanten der Kontur als Sollkontur, oder speichern Sie das Modell als STEP</translation>
    </message>
    <message>
        <source>the model is not prismatic: vertical faces do not go all the way round its outline; {}</source>
        <translation>das Modell ist nicht prismatisch: senkrechte Flächen gehen nicht ganz um seinen Umriss; {}</translation>
    </message>
    <message>
        <source>the model has no height</source>
        <translation>das Modell hat keine Höhe</translation>
    </message>
    <message>
        <source>{} edges of the profile meet at {}; leave one way through</source>
        <translation>{} Kanten des Profils treffen sich bei {}; lassen Sie einen Weg hindurch</translation>
    </message>
    <message>
        <source>the model is not prismatic: between {} and {} it stands out of its outline; {}</source>
        <translation>das Modell ist nicht prismatisch: zwischen {} und {} ragt es aus seinem Umriss; {}</translation>
    </message>
    <message>
        <source>the model is not prismatic: the side face near {} is not vertical; {}</source>
        <translation>das Modell ist nicht prismatisch: die Seitenfläche nahe {} steht nicht senkrecht; {}</translation>
    </message>
    <message>
        <source>unknown setting {}; known are {}</source>
        <translation>unbekannte Einstellung {}; bekannt sind {}</translation>
    </message>
    <message>
        <source>{}: the dressup has no operation below it</source>
        <translation>{}: unter der Korrektur liegt keine Operation</translation>
    </message>
    <message>
        <source>{}: the operation has no path; recompute it</source>
        <translation>{}: die Operation hat keine Bahn; berechnen Sie sie neu</translation>
    </message>
    <message>
        <source>{}: the operation cuts along no contour; check its base geometry, and that its FinalDepth lies below the edges that are selected</source>
        <translation>{}: die Operation schneidet entlang keiner Kontur; prüfen Sie ihre Basisgeometrie, und dass ihre FinalDepth unter den gewählten Kanten liegt</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>keine solche Datei</translation>
    </message>
    <message>
        <source>the document has {} objects called {}</source>
        <translation>das Dokument hat {} Objekte namens {}</translation>
    </message>
    <message>
        <source>the document is empty or damaged</source>
        <translation>das Dokument ist leer oder beschädigt</translation>
    </message>
    <message>
        <source>not a FreeCAD document</source>
        <translation>kein FreeCAD-Dokument</translation>
    </message>
    <message>
        <source>the path of {} is not the one the measured part was cut with: the difference between the two counts as an error of the machine; measure a part cut with the path as it is now</source>
        <translation>die Bahn von {} ist nicht die, mit der das gemessene Teil geschnitten wurde: der Unterschied zählt als Fehler der Maschine; messen Sie ein Teil, das mit der jetzigen Bahn geschnitten wurde</translation>
    </message>
    <message>
        <source>{}: the operation stands in no job</source>
        <translation>{}: die Operation steht in keinem Auftrag</translation>
    </message>
    <message>
        <source>{}: a dressup lies on this operation; choose the dressup</source>
        <translation>{}: über dieser Operation liegt ein Dressup; wählen Sie das Dressup</translation>
    </message>
    <message>
        <source>a table of stiffness goes along one contour, the nominal has {}</source>
        <translation>eine Steifigkeitstabelle gilt entlang einer Kontur, das Nennprofil hat {}</translation>
    </message>
    <message>
        <source>{}: its analysis has {} loads, one force on one place is needed</source>
        <translation>{}: die Analyse hat {} Lasten, gebraucht wird eine Kraft auf eine Stelle</translation>
    </message>
    <message>
        <source>{}: {} acts on {} places, not on one</source>
        <translation>{}: {} wirkt auf {} Stellen, nicht auf eine</translation>
    </message>
    <message>
        <source>{}: {} acts neither along X nor along Y</source>
        <translation>{}: {} wirkt weder entlang X noch entlang Y</translation>
    </message>
    <message>
        <source>{}: no displacements of the nodes at {}.{}, calculate it again</source>
        <translation>{}: keine Knotenverschiebungen bei {}.{}, rechnen Sie noch einmal</translation>
    </message>
    <message>
        <source>{}: the wall moves against its load or not at all</source>
        <translation>{}: die Wand bewegt sich gegen ihre Last oder gar nicht</translation>
    </message>
    <message>
        <source>{}: its load at {} is not on the contour</source>
        <translation>{}: die Last bei {} liegt nicht auf der Kontur</translation>
    </message>
    <message>
        <source>{}: another result loads the place at {} along {}</source>
        <translation>{}: ein anderes Ergebnis belastet die Stelle bei {} entlang {}</translation>
    </message>
    <message>
        <source>{}: the measurement holds no file</source>
        <translation>{}: die Messung enthält keine Datei</translation>
    </message>
    <message>
        <source>cannot be read: {}</source>
        <translation>nicht lesbar: {}</translation>
    </message>
    <message>
        <source>{} is no Profile or Pocket operation: give the contour with {}</source>
        <translation>{} ist keine Profil- oder Taschenoperation: geben Sie die Kontur mit {} an</translation>
    </message>
    <message>
        <source>the corrected path has a move that FreeCAD's Path cannot hold: use lines or arcs</source>
        <translation>die korrigierte Bahn hat eine Bewegung, die FreeCADs Path nicht fassen kann: nehmen Sie Linien oder Bögen</translation>
    </message>
    <message>
        <source>FreeCAD is asked for {}, which it cannot do</source>
        <translation>von FreeCAD wird {} verlangt, was es nicht kann</translation>
    </message>
    <message>
        <source>{}: the profile has no dressup</source>
        <translation>{}: das Profil hat keine Aufbereitung</translation>
    </message>
    <message>
        <source>a first cut is made before anything is measured</source>
        <translation>ein erster Schnitt wird gemacht, bevor etwas gemessen ist</translation>
    </message>
    <message>
        <source>{} is a measured part of {} already: switch it on instead</source>
        <translation>{} ist schon ein gemessenes Teil von {}: schalten Sie es stattdessen ein</translation>
    </message>
    <message>
        <source>the file holds no shape</source>
        <translation>die Datei enthält keine Form</translation>
    </message>
    <message>
        <source>the file holds no line or curve</source>
        <translation>die Datei enthält keine Linie oder Kurve</translation>
    </message>
    <message>
        <source>not a STEP, IGES or BREP file that FreeCAD can read</source>
        <translation>keine STEP-, IGES- oder BREP-Datei, die FreeCAD lesen kann</translation>
    </message>
    <message>
        <source>this FreeCAD cannot read the DXF file; save the contour as STEP</source>
        <translation>dieses FreeCAD kann die DXF-Datei nicht lesen; speichern Sie die Kontur als STEP</translation>
    </message>
    <message>
        <source>{}: the nominal of a document comes from an object, a CAD file or a profile.json</source>
        <translation>{}: das Nennprofil eines Dokuments kommt aus einem Objekt, einer CAD-Datei oder einer profile.json</translation>
    </message>
    <message>
        <source>“{}”</source>
        <translation>„{}“</translation>
    </message>
    <message>
        <source>{}, line {}</source>
        <translation>{}, Zeile {}</translation>
    </message>
    <message>
        <source>line {}</source>
        <translation>Zeile {}</translation>
    </message>
    <message>
        <source>a batch needs a plain Python beside FreeCAD's: none was found on the PATH</source>
        <translation>ein Stapel braucht ein eigenes Python neben dem von FreeCAD: im PATH wurde keines gefunden</translation>
    </message>
    <message>
        <source>{} is not known here: a batch has [defaults] and [[job]]</source>
        <translation>{} ist hier nicht bekannt: ein Stapel hat [defaults] und [[job]]</translation>
    </message>
    <message>
        <source>a batch needs at least one table [[job]]</source>
        <translation>ein Stapel braucht mindestens eine Tabelle [[job]]</translation>
    </message>
    <message>
        <source>defaults must be a table</source>
        <translation>defaults muss eine Tabelle sein</translation>
    </message>
    <message>
        <source>job {}: its name must be one line of text</source>
        <translation>Auftrag {}: sein Name muss eine Zeile Text sein</translation>
    </message>
    <message>
        <source>{}: verb is one of {}, not {!r}</source>
        <translation>{}: verb ist eines von {}, nicht {!r}</translation>
    </message>
    <message>
        <source>no TOML in UTF-8: {}</source>
        <translation>kein TOML in UTF-8: {}</translation>
    </message>
    <message>
        <source>defaults: {} is no option</source>
        <translation>defaults: {} ist keine Option</translation>
    </message>
    <message>
        <source>{}: {} is no option of {}</source>
        <translation>{}: {} ist keine Option von {}</translation>
    </message>
    <message>
        <source>{}: {} = {} is not possible</source>
        <translation>{}: {} = {} ist nicht möglich</translation>
    </message>
    <message>
        <source>{}: two jobs have this name</source>
        <translation>{}: zwei Aufträge heißen so</translation>
    </message>
    <message>
        <source>{}: {} and {} both write {}</source>
        <translation>{}: {} und {} schreiben beide {}</translation>
    </message>
    <message>
        <source>{}: {} reads {}, which {} writes: jobs run at the same time; make two batches of them</source>
        <translation>{}: {} liest {}, das {} schreibt: Aufträge laufen gleichzeitig; machen Sie zwei Stapel daraus</translation>
    </message>
    <message>
        <source>alignment: the points do not determine the {}; the fit leaves it alone</source>
        <translation>Einpassung: die Punkte bestimmen {} nicht; die Einpassung lässt es, wie es ist</translation>
    </message>
    <message>
        <source>alignment: {} of {} points ({:.0f} %) lie off the rest and have no weight in the fit; is a side of the part displaced?</source>
        <translation>Einpassung: {} von {} Punkten ({:.0f} %) liegen abseits der übrigen und zählen nicht; ist eine Seite des Teils versetzt?</translation>
    </message>
    <message>
        <source>alignment: the fit hides {:.0f} % of a constant deviation such as a wrong tool or ball radius (mean {} before, {} after)</source>
        <translation>Einpassung: sie verdeckt {:.0f} % einer gleichmäßigen Abweichung wie von einem falschen Werkzeug- oder Kugelradius (Mittel {} vorher, {} nachher)</translation>
    </message>
    <message>
        <source>alignment: the part measures {:.6f} +- {:.6f} of the profile's size ({} at {}); the scale is not applied: check temperature and unit</source>
        <translation>Einpassung: das Teil misst das {:.6f}-Fache +- {:.6f} der Größe des Profils ({} bei {}); der Maßstab wird nicht angewandt: prüfen Sie Temperatur und Einheit</translation>
    </message>
    <message>
        <source>{}: give none, shift, rigid, or some of x, y, turn joined by +; then :zone or :all</source>
        <translation>{}: geben Sie none, shift, rigid oder einige von x, y, turn mit + verbunden; dann :zone oder :all</translation>
    </message>
    <message>
        <source>{}: alignment: no end after {} steps, the last one {}</source>
        <translation>{}: Einpassung: kein Ende nach {} Schritten, der letzte {}</translation>
    </message>
    <message>
        <source>{}: alignment: no minimum zone after {} steps</source>
        <translation>{}: Einpassung: keine kleinste Zone nach {} Schritten</translation>
    </message>
    <message>
        <source>{}: alignment with {} free degrees of freedom needs at least {} points, there are {}</source>
        <translation>{}: Einpassung mit {} Freiheitsgraden braucht mindestens {} Punkte, es sind {}</translation>
    </message>
    <message>
        <source>{}: alignment: {:.0f} % of the points stay farther than {} from the profile; check unit, work frame, {} and {}</source>
        <translation>{}: Einpassung: {:.0f} % der Punkte bleiben weiter als {} vom Profil; prüfen Sie Einheit, Werkstücksystem, {} und {}</translation>
    </message>
    <message>
        <source>minimum zone: the linear programme failed: {}</source>
        <translation>kleinste Zone: das lineare Programm hat keine Lösung: {}</translation>
    </message>
    <message>
        <source>{}: alignment: the usable points do not determine the motion</source>
        <translation>{}: Einpassung: die brauchbaren Punkte bestimmen die Bewegung nicht</translation>
    </message>
    <message>
        <source>touched along X or along Y: the slope is too near to 45 degrees to tell, and the file does not say</source>
        <translation>entlang X oder Y angetastet: die Steigung ist zu nah an 45 Grad, und die Datei sagt es nicht</translation>
    </message>
    <message>
        <source>touched neither along X nor along Y by the slope of the profile, and the file does not say</source>
        <translation>nach der Steigung des Profils weder entlang X noch Y angetastet, und die Datei sagt es nicht</translation>
    </message>
    <message>
        <source>the probe did not travel towards the material here</source>
        <translation>der Taster fuhr hier nicht auf das Material zu</translation>
    </message>
    <message>
        <source>the points lie {:+.3f} to {} off the profile, by its slope, as if the control had shifted them along X and Y by the radius of a ball of about {}; taken back, {:.0f} of {} of scatter are left: {} with {} from the probe's calibration</source>
        <translation>die Punkte liegen {:+.3f} bis {} neben dem Profil, je nach Steigung, als hätte die Steuerung sie entlang X und Y um den Radius einer Kugel von etwa {} verschoben; zurückgenommen bleiben {:.0f} von {} Streuung: {} mit {} aus der Kalibrierung des Tasters</translation>
    </message>
    <message>
        <source>with the shift by {} along the axis of travel taken back, {} times (1 - cos) of the slope is left, {} of scatter, {} without it</source>
        <translation>ist die Verschiebung um {} entlang der Fahrachse zurückgenommen, bleibt {} mal (1 - cos) der Steigung, {} Streuung, ohne sie {}</translation>
    </message>
    <message>
        <source>{}: the points were not shifted along the axis: {}, or centre with {}</source>
        <translation>{}: die Punkte wurden nicht entlang der Achse verschoben: {}, oder centre mit {}</translation>
    </message>
    <message>
        <source>{}: {} seems to be about {:.2f}; see its calibration</source>
        <translation>{}: {} scheint etwa {:.2f} zu sein; sehen Sie in die Kalibrierung</translation>
    </message>
    <message>
        <source>{}: the probe's radius can be taken back at none of {} points, most are {}: check {}, {} and the work frame, or give each point's direction of travel</source>
        <translation>{}: der Tasterradius lässt sich bei keinem von {} Punkten zurücknehmen, die meisten: {}; prüfen Sie {}, {} und das Werkstücksystem, oder geben Sie die Fahrtrichtung jedes Punkts an</translation>
    </message>
    <message>
        <source>{}: two radii of a shift need a probe that says the effective one</source>
        <translation>{}: zwei Verschiebungsradien brauchen einen Taster, der den wirksamen nennt</translation>
    </message>
    <message>
        <source>{}: the probe travelled along no axis, and control_radius has one radius for X and another one for Y</source>
        <translation>{}: der Taster fuhr entlang keiner Achse, und control_radius hat für X und Y verschiedene Radien</translation>
    </message>
    <message>
        <source>the program has no feed move in the XY plane that could follow a contour</source>
        <translation>das Programm hat keine Vorschubbewegung in der XY-Ebene, die einer Kontur folgen könnte</translation>
    </message>
    <message>
        <source>{}: the ball is as large as the cutter, so its centres lie on the path and do not tell the side of the material: say {} or {}</source>
        <translation>{}: die Kugel ist so groß wie der Fräser, ihre Mittelpunkte liegen also auf der Bahn und sagen nicht, auf welcher Seite das Material ist: geben Sie {} oder {} an</translation>
    </message>
    <message>
        <source>{}: the points lie on both sides of the path or far from it ({} right and {} left of {}): say {} or {}, and check {}, the unit and the work frame</source>
        <translation>{}: die Punkte liegen auf beiden Seiten der Bahn oder weit davon ({} rechts und {} links von {}): geben Sie {} oder {} an, und prüfen Sie {}, die Einheit und das Werkstücksystem</translation>
    </message>
    <message>
        <source>{}: the points lie typically {} off the nearest contour that {} cuts: check {}, {}, {}, {}, and the work frame</source>
        <translation>{}: die Punkte liegen typisch {} neben der nächsten Kontur, die {} schneidet: prüfen Sie {}, {}, {}, {} und das Werkstücksystem</translation>
    </message>
    <message>
        <source>steps of the wall without measured points, down to {}: left as they are</source>
        <translation>Stufen der Wand ohne Messpunkte, hinab bis {}: sie bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>another contour</source>
        <translation>eine andere Kontur</translation>
    </message>
    <message>
        <source>{} other contours</source>
        <translation>{} andere Konturen</translation>
    </message>
    <message>
        <source>the program cuts {} without measured points: left as it is</source>
        <translation>das Programm schneidet {} ohne Messpunkte: das bleibt, wie es ist</translation>
    </message>
    <message>
        <source>the program cuts no contour in the XY plane</source>
        <translation>das Programm schneidet keine Kontur in der XY-Ebene</translation>
    </message>
    <message>
        <source>in an inner corner or hollow that the cutter cannot reach</source>
        <translation>in einer Innenecke oder Höhlung, die der Fräser nicht erreicht</translation>
    </message>
    <message>
        <source>farther than {} from the profile</source>
        <translation>weiter als {} vom Profil</translation>
    </message>
    <message>
        <source>beyond the end of the open profile</source>
        <translation>jenseits des Endes des offenen Profils</translation>
    </message>
    <message>
        <source>at a corner, where the profile has no single normal and the file gives none</source>
        <translation>an einer Ecke, wo das Profil keine eindeutige Normale hat und die Datei keine angibt</translation>
    </message>
    <message>
        <source>two branches of the profile are equally near and the file gives no normal</source>
        <translation>zwei Zweige des Profils sind gleich nah, und die Datei gibt keine Normale an</translation>
    </message>
    <message>
        <source>touched on another surface: its own normal is more than 60 degrees off the profile's there</source>
        <translation>auf einer anderen Fläche angetastet: die eigene Normale weicht um mehr als 60 Grad von der des Profils ab</translation>
    </message>
    <message>
        <source>{}: the program cuts the wall in steps down to {}, and the points have no height: on which of them each lies cannot be told; give the file with its third coordinate</source>
        <translation>{}: das Programm schneidet die Wand in Stufen bis {}, und die Punkte haben keine Höhe: auf welcher Stufe jeder liegt, ist nicht zu sagen; geben Sie die Datei mit ihrer dritten Koordinate</translation>
    </message>
    <message>
        <source>{}: the probe's radius is not taken off yet: comparison.ball_radius.contact_known comes first</source>
        <translation>{}: der Tasterradius ist noch nicht abgezogen: erst kommt comparison.ball_radius.contact_known</translation>
    </message>
    <message>
        <source>{}: none of the {} points can be used, most are {}; check unit, work frame, {} and {}</source>
        <translation>{}: keiner der {} Punkte ist brauchbar, die meisten: {}; prüfen Sie Einheit, Werkstücksystem, {} und {}</translation>
    </message>
    <message>
        <source>the offset path does not close near {}: check {} and {}, or give the contour with {}</source>
        <translation>die versetzte Bahn schließt sich nahe {} nicht: prüfen Sie {} und {}, oder geben Sie die Kontur mit {}</translation>
    </message>
    <message>
        <source>the path only circles points at the tool radius {}, or turns tighter than it everywhere: there is no contour; check {} and {}</source>
        <translation>die Bahn umkreist nur Punkte mit dem Werkzeugradius {} oder ist überall enger gekrümmt: es gibt keine Kontur; prüfen Sie {} und {}</translation>
    </message>
    <message>
        <source>the stretch of {} through {} was measured at that place only: {} hold all along it</source>
        <translation>die Strecke von {} durch {} wurde nur dort gemessen: {} gelten auf ihrer ganzen Länge</translation>
    </message>
    <message>
        <source>a correction of {} is needed at {} ({} points), more than {}; nothing was corrected: look at the place in the report of a check, and say a larger {} if it is right</source>
        <translation>eine Korrektur von {} ist nötig bei {} ({} Punkte), mehr als {}; nichts wurde korrigiert: sehen Sie die Stelle im Bericht einer Prüfung an, und geben Sie {} größer an, wenn sie stimmt</translation>
    </message>
    <message>
        <source>the stretch of {} near {} has no usable point</source>
        <translation>auf der Strecke von {} nahe {} ist kein brauchbarer Punkt</translation>
    </message>
    <message>
        <source>between the points the correction swings to {} at {}, more than {}: use a stronger {}; nothing was corrected</source>
        <translation>zwischen den Punkten schwingt die Korrektur auf {} bei {}, mehr als {}: stärkeren {} verwenden; nichts wurde korrigiert</translation>
    </message>
    <message>
        <source>{}: it follows its neighbours, {} to {}</source>
        <translation>{}: sie folgt ihren Nachbarn, {} bis {}</translation>
    </message>
    <message>
        <source> and {} shorter gaps</source>
        <translation> und {} kürzere Lücken</translation>
    </message>
    <message>
        <source>no usable point on {} between {} and {}{}: the correction runs straight across or holds its last value</source>
        <translation>kein brauchbarer Punkt auf {} zwischen {} und {}{}: die Korrektur läuft gerade hinüber oder hält ihren letzten Wert</translation>
    </message>
    <message>
        <source>{}: it is not corrected</source>
        <translation>{}: sie wird nicht korrigiert</translation>
    </message>
    <message>
        <source>{}:{}: this measurement was applied on {} already; cut and measure a new part with the corrected program first</source>
        <translation>{}:{}: diese Messung wurde schon am {} angewandt; fräsen und messen Sie erst ein neues Teil mit dem korrigierten Programm</translation>
    </message>
    <message>
        <source>{}:{}: the program was corrected on {}, so it does not show the nominal any more; give the first, uncorrected program or the drawing with {}</source>
        <translation>{}:{}: das Programm wurde am {} korrigiert und zeigt das Nennprofil nicht mehr; geben Sie das erste, unkorrigierte Programm oder die Zeichnung mit {} an</translation>
    </message>
    <message>
        <source>line {}: the comment that says which measurement corrected this program is damaged; take the corrected program as it was written</source>
        <translation>Zeile {}: der Kommentar, der sagt, welche Messung dieses Programm korrigiert hat, ist beschädigt; nehmen Sie das korrigierte Programm, wie es geschrieben wurde</translation>
    </message>
    <message>
        <source>{}: more than {} would hide what is to be corrected</source>
        <translation>{}: mehr als {} würde verdecken, was zu korrigieren ist</translation>
    </message>
    <message>
        <source>{} needs {}, the depth that the measured part was cut at</source>
        <translation>{} braucht {}, die Tiefe, mit der das gemessene Teil geschnitten wurde</translation>
    </message>
    <message>
        <source>a first cut that leaves stock is made before anything is measured or predicted</source>
        <translation>ein erster Schnitt, der Aufmaß lässt, wird gemacht, bevor etwas gemessen oder vorhergesagt ist</translation>
    </message>
    <message>
        <source>{} takes the whole error out: it goes with neither {} nor {}</source>
        <translation>{} nimmt den ganzen Fehler heraus: es geht weder mit {} noch mit {}</translation>
    </message>
    <message>
        <source>{} is given {} times and measured parts {}: give it once, or once for each {}</source>
        <translation>{} ist {}-mal angegeben, gemessene Teile: {}; einmal angeben, oder einmal für jedes von {}</translation>
    </message>
    <message>
        <source>{} qif needs {}, the width of the profile's tolerance zone on the drawing</source>
        <translation>{} qif braucht {}, die Breite der Toleranzzone des Profils auf der Zeichnung</translation>
    </message>
    <message>
        <source> or {}</source>
        <translation> oder {}</translation>
    </message>
    <message>
        <source>{} belongs to {}, not to {}</source>
        <translation>{} gehört zu {}, nicht zu {}</translation>
    </message>
    <message>
        <source>{}: write the number or name and the diameter of a tool in mm, as {}</source>
        <translation>{}: schreiben Sie Nummer oder Namen und den Durchmesser eines Werkzeugs in mm, als {}</translation>
    </message>
    <message>
        <source>at {}: </source>
        <translation>bei {}: </translation>
    </message>
    <message>
        <source>{}the commanded depth is {}, not above 0: a transfer function needs a cut; check {}</source>
        <translation>{}die befohlene Tiefe ist {}, nicht über 0: eine Übertragungsfunktion braucht einen Schnitt; prüfen Sie {}</translation>
    </message>
    <message>
        <source>{}{} of a commanded depth of {} stayed: the transfer function delta/(H - delta) has no meaning there; check {}</source>
        <translation>{}{} einer befohlenen Tiefe von {} blieben stehen: die Übertragungsfunktion delta/(H - delta) hat dort keinen Sinn; prüfen Sie {}</translation>
    </message>
    <message>
        <source>the parts of different depth were measured at different places: nothing can be compared</source>
        <translation>die verschieden tief geschnittenen Teile wurden an verschiedenen Stellen gemessen: nichts lässt sich vergleichen</translation>
    </message>
    <message>
        <source>{}{:.0f} % of the difference between the depths stayed: no transfer function follows from that; check {}</source>
        <translation>{}{:.0f} % des Unterschieds der Tiefen blieben stehen: daraus folgt keine Übertragungsfunktion; prüfen Sie {}</translation>
    </message>
    <message>
        <source>{}the normal is {:.0f} degrees off {}: a deviation along {} says little there; use {}</source>
        <translation>{}die Normale steht {:.0f} Grad schräg zu {}: eine Abweichung entlang {} sagt dort wenig; verwenden Sie {}</translation>
    </message>
    <message>
        <source>check {} and which part was cut at which</source>
        <translation>prüfen Sie {}, und welches Teil mit welcher geschnitten wurde</translation>
    </message>
    <message>
        <source>the tool may be larger than stated or the path off; measure a part cut at another {} as well, or use {}</source>
        <translation>das Werkzeug kann größer sein als angegeben oder die Bahn daneben; messen Sie auch ein Teil mit anderer {}, oder verwenden Sie {}</translation>
    </message>
    <message>
        <source>at {} the transfer function would be {:+.4f}, negative beyond its uncertainty of {:.4f}: no elastic system removes more than it is told to; {}</source>
        <translation>bei {} wäre die Übertragungsfunktion {:+.4f}, negativ über ihre Unsicherheit von {:.4f} hinaus: kein elastisches System nimmt mehr ab als befohlen; {}</translation>
    </message>
    <message>
        <source>the transfer function would be {:.3f} in the middle: {:.0f} % of the depth would stay, which no machine is left to do; check {}</source>
        <translation>die Übertragungsfunktion wäre im Mittel {:.3f}: {:.0f} % der Tiefe blieben stehen, was keine Maschine tut; prüfen Sie {}</translation>
    </message>
    <message>
        <source>the transfer function is {:.4f} in the middle: only {:.1f} % of the depth stays, less than milling machines give way; check {}</source>
        <translation>die Übertragungsfunktion ist im Mittel {:.4f}: nur {:.1f} % der Tiefe bleiben stehen, weniger als Fräsmaschinen nachgeben; prüfen Sie {}</translation>
    </message>
    <message>
        <source>the transfer function is {:.3f} at {}: {:.0f} % of the depth stays; check {}</source>
        <translation>die Übertragungsfunktion ist {:.3f} bei {}: {:.0f} % der Tiefe bleiben stehen; prüfen Sie {}</translation>
    </message>
    <message>
        <source>{} parts cut {} mm deep: the transfer function is taken from the difference, the constant offset apart; deviations are shown as at the depth of the first</source>
        <translation>{} Teile, {} mm tief geschnitten: die Übertragungsfunktion folgt aus dem Unterschied, der gleichbleibende Versatz getrennt; Abweichungen stehen wie bei der Tiefe des ersten</translation>
    </message>
    <message>
        <source>{} stretches of contours without a measured point are left as they are</source>
        <translation>{} Strecken von Konturen ohne gemessenen Punkt bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>the parts were cut at different depths: say with {} what the next one takes off</source>
        <translation>die Teile wurden verschieden tief geschnitten: sagen Sie mit {}, was der nächste Schnitt abnimmt</translation>
    </message>
    <message>
        <source>gain {:g} leaves {:.0f} % of what the next part would show on purpose</source>
        <translation>Verstärkung {:g} lässt absichtlich {:.0f} % dessen, was das nächste Teil zeigen würde</translation>
    </message>
    <message>
        <source>one depth cannot tell a constant offset (tool radius, backlash, edge force) from elastic response: all of it is taken as elastic, which is right at the depth measured; for another depth measure two</source>
        <translation>eine einzige Tiefe kann einen gleichbleibenden Versatz (Werkzeugradius, Umkehrspiel, Schneidkantenkraft) nicht vom Nachgeben unterscheiden: alles gilt als elastisch, was bei der gemessenen Tiefe stimmt; für eine andere Tiefe zwei messen</translation>
    </message>
    <message>
        <source>deviations along {} with depths along the normal correct by {} more on average than {}</source>
        <translation>Abweichungen entlang {} mit Tiefen entlang der Normalen korrigieren im Mittel um {} mehr als {}</translation>
    </message>
    <message>
        <source>say {}: </source>
        <translation>geben Sie an {}: </translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>the profile has a cusp or a point where its parametrisation stands still</source>
        <translation>das Profil hat eine Spitze oder einen Punkt, an dem seine Parametrisierung stillsteht</translation>
    </message>
    <message>
        <source>the profile has no contour</source>
        <translation>das Profil hat keine Kontur</translation>
    </message>
    <message>
        <source>the profile has no length</source>
        <translation>das Profil hat keine Länge</translation>
    </message>
    <message>
        <source>the profile has a cusp or a point where its parametrisation stands still near {}</source>
        <translation>das Profil hat eine Spitze oder einen Punkt, an dem seine Parametrisierung stillsteht, nahe {}</translation>
    </message>
    <message>
        <source>contour {} of the profile has no length</source>
        <translation>Kontur {} des Profils hat keine Länge</translation>
    </message>
    <message>
        <source>contour {} of the profile has a gap of {} at {}</source>
        <translation>Kontur {} des Profils hat eine Lücke von {} bei {}</translation>
    </message>
    <message>
        <source>profile: unit must be mm and material left</source>
        <translation>Profil: die Einheit muss mm sein und das Material links liegen</translation>
    </message>
    <message>
        <source>profile: {!r} is missing or of the wrong kind</source>
        <translation>Profil: {!r} fehlt oder ist von falscher Art</translation>
    </message>
    <message>
        <source>not a millcorr profile: {}</source>
        <translation>kein Profil von millcorr: {}</translation>
    </message>
    <message>
        <source>{} needs a name: the measuring program is written there</source>
        <translation>{} braucht einen Namen: dorthin wird das Messprogramm geschrieben</translation>
    </message>
    <message>
        <source>{}: say the radius at which the probe triggers</source>
        <translation>{}: geben Sie den Radius an, bei dem der Taster schaltet</translation>
    </message>
    <message>
        <source>{} needs a name: the corrected program is written there</source>
        <translation>{} braucht einen Namen: dorthin wird das korrigierte Programm geschrieben</translation>
    </message>
    <message>
        <source>name the program that finishes the part, and the one to write</source>
        <translation>nennen Sie das Programm, das das Teil fertigstellt, und das zu schreibende</translation>
    </message>
    <message>
        <source>name the setup and the directory for the report</source>
        <translation>nennen Sie die Einrichtung und das Verzeichnis für den Bericht</translation>
    </message>
    <message>
        <source>Share: the first cut takes more than 0 and less than 1 of the allowance</source>
        <translation>Anteil: der erste Schnitt nimmt mehr als 0 und weniger als 1 des Aufmaßes</translation>
    </message>
    <message>
        <source>Stock: say how much stands on the finished contour</source>
        <translation>Aufmaß: geben Sie an, wie viel auf der fertigen Kontur steht</translation>
    </message>
    <message>
        <source>the angle does not give where this line ends</source>
        <translation>der Winkel ergibt nicht, wo dieser Satz endet</translation>
    </message>
    <message>
        <source>the number of turns P of an arc is a whole number from 1</source>
        <translation>die Zahl der Umdrehungen P eines Kreisbogens ist eine ganze Zahl ab 1</translation>
    </message>
    <message>
        <source>arc with a radius and a centre: keep one of them</source>
        <translation>Kreisbogen mit Radius und Mittelpunkt: behalten Sie eines davon</translation>
    </message>
    <message>
        <source>arc without a centre: state I, J, K or R</source>
        <translation>Kreisbogen ohne Mittelpunkt: geben Sie I, J, K oder R an</translation>
    </message>
    <message>
        <source>arc with an absolute centre (G90.1) needs both of its coordinates</source>
        <translation>ein Kreisbogen mit absolutem Mittelpunkt (G90.1) braucht beide Koordinaten</translation>
    </message>
    <message>
        <source>arc whose end is not on its circle: correct it</source>
        <translation>Kreisbogen, dessen Ende nicht auf seinem Kreis liegt: berichtigen Sie ihn</translation>
    </message>
    <message>
        <source>arc of radius zero: state its centre</source>
        <translation>Kreisbogen mit Radius null: geben Sie seinen Mittelpunkt an</translation>
    </message>
    <message>
        <source>arc radius shorter than half the way to its end: correct R</source>
        <translation>Radius kürzer als der halbe Weg zum Ende des Bogens: berichtigen Sie R</translation>
    </message>
    <message>
        <source>arc with R ends where it starts: state I, J for a circle</source>
        <translation>ein Bogen mit R endet, wo er beginnt: geben Sie für einen Vollkreis I, J an</translation>
    </message>
    <message>
        <source>G92 shifts the frame</source>
        <translation>G92 verschiebt das Koordinatensystem</translation>
    </message>
    <message>
        <source>G92.3 shifts the frame</source>
        <translation>G92.3 verschiebt das Koordinatensystem</translation>
    </message>
    <message>
        <source>G52 turns the frame</source>
        <translation>G52 verändert das Koordinatensystem</translation>
    </message>
    <message>
        <source>G10 may change a work offset</source>
        <translation>G10 kann eine Nullpunktverschiebung ändern</translation>
    </message>
    <message>
        <source>G11 shifts or turns the frame</source>
        <translation>G11 verschiebt oder dreht das Koordinatensystem</translation>
    </message>
    <message>
        <source>G68 rotates the frame</source>
        <translation>G68 dreht das Koordinatensystem</translation>
    </message>
    <message>
        <source>G68.1 rotates the frame</source>
        <translation>G68.1 dreht das Koordinatensystem</translation>
    </message>
    <message>
        <source>G68.2 tilts the plane</source>
        <translation>G68.2 schwenkt die Ebene</translation>
    </message>
    <message>
        <source>G68.3 tilts the plane</source>
        <translation>G68.3 schwenkt die Ebene</translation>
    </message>
    <message>
        <source>G68.4 tilts the plane</source>
        <translation>G68.4 schwenkt die Ebene</translation>
    </message>
    <message>
        <source>G68.5 turns the frame</source>
        <translation>G68.5 dreht das Koordinatensystem</translation>
    </message>
    <message>
        <source>G92.5 turns the frame</source>
        <translation>G92.5 dreht das Koordinatensystem</translation>
    </message>
    <message>
        <source>G254 lets the work offset turn with the part</source>
        <translation>G254 lässt die Nullpunktverschiebung mit dem Werkstück drehen</translation>
    </message>
    <message>
        <source>G51 scales the frame</source>
        <translation>G51 skaliert das Koordinatensystem</translation>
    </message>
    <message>
        <source>G51.1 mirrors the frame</source>
        <translation>G51.1 spiegelt das Koordinatensystem</translation>
    </message>
    <message>
        <source>G101 mirrors the frame</source>
        <translation>G101 spiegelt das Koordinatensystem</translation>
    </message>
    <message>
        <source>G16 states polar coordinates</source>
        <translation>G16 gibt Polarkoordinaten an</translation>
    </message>
    <message>
        <source>G12.1 interpolates in polar coordinates</source>
        <translation>G12.1 interpoliert in Polarkoordinaten</translation>
    </message>
    <message>
        <source>G112 interpolates in polar coordinates</source>
        <translation>G112 interpoliert in Polarkoordinaten</translation>
    </message>
    <message>
        <source>G7.1 interpolates on a cylinder</source>
        <translation>G7.1 interpoliert auf einem Zylinder</translation>
    </message>
    <message>
        <source>G107 interpolates on a cylinder</source>
        <translation>G107 interpoliert auf einem Zylinder</translation>
    </message>
    <message>
        <source>G7 states diameters</source>
        <translation>G7 gibt Durchmesser an</translation>
    </message>
    <message>
        <source>G43.4 controls the tool centre point</source>
        <translation>G43.4 führt die Werkzeugspitze (TCPM)</translation>
    </message>
    <message>
        <source>G43.5 controls the tool centre point</source>
        <translation>G43.5 führt die Werkzeugspitze (TCPM)</translation>
    </message>
    <message>
        <source>G234 controls the tool centre point</source>
        <translation>G234 führt die Werkzeugspitze (TCPM)</translation>
    </message>
    <message>
        <source>G66 calls a macro at every move</source>
        <translation>G66 ruft bei jeder Bewegung ein Makro auf</translation>
    </message>
    <message>
        <source>G93 states the feed as inverse time</source>
        <translation>G93 gibt den Vorschub als Kehrwert der Zeit an</translation>
    </message>
    <message>
        <source>ROT, MIRROR or SCALE changes the frame</source>
        <translation>ROT, MIRROR oder SCALE ändert das Koordinatensystem</translation>
    </message>
    <message>
        <source>CYCLE800 swivels the frame</source>
        <translation>CYCLE800 schwenkt das Koordinatensystem</translation>
    </message>
    <message>
        <source>MCALL calls a cycle behind every move</source>
        <translation>MCALL ruft hinter jeder Bewegung einen Zyklus auf</translation>
    </message>
    <message>
        <source>G65 calls a macro</source>
        <translation>G65 ruft ein Makro auf</translation>
    </message>
    <message>
        <source>this line becomes several moves, but its M code belongs behind the last of them</source>
        <translation>aus diesem Satz werden mehrere Bewegungen, sein M-Code gehört aber hinter die letzte davon</translation>
    </message>
    <message>
        <source>{}: put the M code on a line of its own</source>
        <translation>{}: schreiben Sie den M-Code in einen eigenen Satz</translation>
    </message>
    <message>
        <source>{}{}{} cannot be corrected: {}</source>
        <translation>{}{}{} kann nicht korrigiert werden: {}</translation>
    </message>
    <message>
        <source>rounding would make another arc of this one: allow more decimals</source>
        <translation>gerundet würde ein anderer Bogen daraus: lassen Sie mehr Nachkommastellen zu</translation>
    </message>
    <message>
        <source>toolpath: an arc of line {} is not in the plane in force there</source>
        <translation>Bahn: ein Bogen der Zeile {} liegt nicht in der Ebene, die dort gilt</translation>
    </message>
    <message>
        <source>the turns of this arc would change: write it as arcs of one turn</source>
        <translation>die Umdrehungen dieses Bogens würden sich ändern: schreiben Sie ihn als Bögen von einer Umdrehung</translation>
    </message>
    <message>
        <source>toolpath: a move of line {} of {} starts {} from where the one before ends</source>
        <translation>Bahn: eine Bewegung der Zeile {} von {} beginnt {} neben dem Ende der vorigen</translation>
    </message>
    <message>
        <source>controls round numbers below zero differently</source>
        <translation>Steuerungen runden Zahlen unter null verschieden</translation>
    </message>
    <message>
        <source>'{}' has no value</source>
        <translation>„{}“ hat keinen Wert</translation>
    </message>
    <message>
        <source>controls divide numbers below zero differently</source>
        <translation>Steuerungen teilen Zahlen unter null verschieden</translation>
    </message>
    <message>
        <source>{} of bits is not computed</source>
        <translation>{} von Bits wird nicht berechnet</translation>
    </message>
    <message>
        <source>an expression is not complete</source>
        <translation>ein Ausdruck ist unvollständig</translation>
    </message>
    <message>
        <source>a bracket is missing</source>
        <translation>eine Klammer fehlt</translation>
    </message>
    <message>
        <source>a bracket is not closed</source>
        <translation>eine Klammer ist nicht geschlossen</translation>
    </message>
    <message>
        <source>{} has no value that this program sets</source>
        <translation>{} hat keinen Wert, den dieses Programm setzt</translation>
    </message>
    <message>
        <source>controls give arc tangents below zero differently</source>
        <translation>Steuerungen geben Arkustangens unter null verschieden an</translation>
    </message>
    <message>
        <source>'{}' is no value</source>
        <translation>„{}“ ist kein Wert</translation>
    </message>
    <message>
        <source>ATAN of one number is not computed</source>
        <translation>ATAN einer einzelnen Zahl wird nicht berechnet</translation>
    </message>
    <message>
        <source>a variable</source>
        <translation>eine Variable</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>this is a binary file or UTF-16 text: save the program as plain text</source>
        <translation>das ist eine Binärdatei oder Text in UTF-16: speichern Sie das Programm als einfachen Text</translation>
    </message>
    <message>
        <source>cannot read '{}': is this a plain-language block?</source>
        <translation>„{}“ ist nicht zu lesen: ist das ein Klartextsatz?</translation>
    </message>
    <message>
        <source>BEGIN PGM without a unit: state MM or INCH</source>
        <translation>BEGIN PGM ohne Einheit: geben Sie MM oder INCH an</translation>
    </message>
    <message>
        <source>this line runs {} times, and its {} and {} want other words: write the runs out, each with lines of its own</source>
        <translation>diese Zeile läuft {}-mal, und ihr {} und ihr {} wollen verschiedene Worte: schreiben Sie die Durchläufe aus, jeden mit eigenen Zeilen</translation>
    </message>
    <message>
        <source>{}{} cannot be corrected: {} is used {} times (line {}); state the numbers in these lines</source>
        <translation>{}{} kann nicht korrigiert werden: {} wird {}-mal gebraucht (Zeile {}); geben Sie die Zahlen in diesen Zeilen an</translation>
    </message>
    <message>
        <source>'{}' would not be read: {}</source>
        <translation>„{}“ wäre nicht zu lesen: {}</translation>
    </message>
    <message>
        <source>toolpath: line {} of {} cannot be written</source>
        <translation>Werkzeugbahn: Zeile {} von {} kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>arc from an unknown start: state the position before it</source>
        <translation>Kreisbogen ab unbekanntem Anfang: geben Sie davor die Position an</translation>
    </message>
    <message>
        <source>G5.1 with a target is not followed</source>
        <translation>G5.1 mit einem Ziel wird nicht verfolgt</translation>
    </message>
    <message>
        <source>arc from an unknown start</source>
        <translation>Kreisbogen ab unbekanntem Anfang</translation>
    </message>
    <message>
        <source>arc with a pitch word along its axis</source>
        <translation>Kreisbogen mit einer Steigung entlang seiner Achse</translation>
    </message>
    <message>
        <source>G5 works in the XY plane only: state G17</source>
        <translation>G5 gilt nur in der XY-Ebene: geben Sie G17 an</translation>
    </message>
    <message>
        <source>G5 needs both I and J, or neither behind another G5</source>
        <translation>G5 braucht I und J, oder keines von beiden hinter einem G5</translation>
    </message>
    <message>
        <source>G5 needs P and Q</source>
        <translation>G5 braucht P und Q</translation>
    </message>
    <message>
        <source>G5 moves X and Y only: move Z on a line of its own</source>
        <translation>G5 bewegt nur X und Y: fahren Sie Z in einem eigenen Satz</translation>
    </message>
    <message>
        <source>the first G5 of a row needs I and J</source>
        <translation>das erste G5 einer Reihe braucht I und J</translation>
    </message>
    <message>
        <source>spline from an unknown start: state the position before it</source>
        <translation>Spline ab unbekanntem Anfang: geben Sie davor die Position an</translation>
    </message>
    <message>
        <source>G{:g} is not a G code</source>
        <translation>G{:g} ist kein G-Code</translation>
    </message>
    <message>
        <source>two {} words on one line: keep the one that is meant</source>
        <translation>zwei Wörter {} in einem Satz: behalten Sie das gemeinte</translation>
    </message>
    <message>
        <source>G{:g} and G{:g} on one line contradict each other</source>
        <translation>G{:g} und G{:g} in einem Satz widersprechen sich</translation>
    </message>
    <message>
        <source>G{:g} is not followed</source>
        <translation>G{:g} wird nicht verfolgt</translation>
    </message>
    <message>
        <source>a rotary or parallel axis moves with this line</source>
        <translation>eine Dreh- oder Parallelachse bewegt sich in diesem Satz mit</translation>
    </message>
    <message>
        <source>no motion code is in force</source>
        <translation>keine Wegbedingung ist in Kraft</translation>
    </message>
    <message>
        <source>axis words behind G80</source>
        <translation>Achswörter hinter G80</translation>
    </message>
    <message>
        <source>canned cycle, never rewritten</source>
        <translation>Bearbeitungszyklus, wird nie umgeschrieben</translation>
    </message>
    <message>
        <source>G28 or G30 leaves the work frame</source>
        <translation>G28 oder G30 verlässt das Werkstücksystem</translation>
    </message>
    <message>
        <source>G53 moves in the machine frame</source>
        <translation>G53 fährt im Maschinensystem</translation>
    </message>
    <message>
        <source>a corner rounding or chamfer that is not followed</source>
        <translation>eine Eckenrundung oder Fase, die nicht verfolgt wird</translation>
    </message>
    <message>
        <source>{}, G90 or G91 is not stated afresh behind it</source>
        <translation>{}, G90 oder G91 steht danach nicht neu</translation>
    </message>
    <message>
        <source>two corner words on one line</source>
        <translation>zwei Eckenwörter in einer Zeile</translation>
    </message>
    <message>
        <source>the feed of the corner is not known</source>
        <translation>der Vorschub der Ecke ist nicht bekannt</translation>
    </message>
    <message>
        <source>this way to state an arc is not followed</source>
        <translation>diese Art, einen Bogen anzugeben, wird nicht verfolgt</translation>
    </message>
    <message>
        <source>behind the end of the program</source>
        <translation>hinter dem Programmende</translation>
    </message>
    <message>
        <source>a corner word without a move</source>
        <translation>ein Eckenwort ohne Bewegung</translation>
    </message>
    <message>
        <source>the control's settings decide which of two feeds holds in the corner</source>
        <translation>die Einstellungen der Steuerung entscheiden, welcher von zwei Vorschüben in der Ecke gilt</translation>
    </message>
    <message>
        <source>{} SUB without its ENDSUB</source>
        <translation>{} SUB ohne sein ENDSUB</translation>
    </message>
    <message>
        <source>no line N{:g} is there to go to</source>
        <translation>kein Satz N{:g}, zu dem gesprungen werden kann</translation>
    </message>
    <message>
        <source>a subprogram is called</source>
        <translation>ein Unterprogramm wird aufgerufen</translation>
    </message>
    <message>
        <source>subprogram {} is called, which is neither in the file nor beside it</source>
        <translation>Unterprogramm {} wird aufgerufen, das weder in der Datei noch daneben ist</translation>
    </message>
    <message>
        <source>subprograms call each other without end</source>
        <translation>Unterprogramme rufen einander ohne Ende auf</translation>
    </message>
    <message>
        <source>M99 with L is not followed</source>
        <translation>M99 mit L wird nicht verfolgt</translation>
    </message>
    <message>
        <source>'{}' is not followed</source>
        <translation>„{}“ wird nicht verfolgt</translation>
    </message>
    <message>
        <source>no label {} is there to go to</source>
        <translation>keine Marke {}, zu der gesprungen werden kann</translation>
    </message>
    <message>
        <source>a loop or choice is not complete</source>
        <translation>eine Schleife oder Verzweigung ist unvollständig</translation>
    </message>
    <message>
        <source>subprogram {} is called, which is not in the file</source>
        <translation>Unterprogramm {} wird aufgerufen, das nicht in der Datei ist</translation>
    </message>
    <message>
        <source>{}: which line comes next is not known</source>
        <translation>{}: welcher Satz folgt, ist nicht bekannt</translation>
    </message>
    <message>
        <source>REPEAT of what stands behind it is not followed</source>
        <translation>REPEAT von etwas, das dahinter steht, wird nicht verfolgt</translation>
    </message>
    <message>
        <source>REPEAT of lines that call or jump is not followed</source>
        <translation>REPEAT von Sätzen, die aufrufen oder springen, wird nicht verfolgt</translation>
    </message>
    <message>
        <source>a loop does not end</source>
        <translation>eine Schleife endet nicht</translation>
    </message>
    <message>
        <source>{} is computed by a macro expression: {}</source>
        <translation>{} wird von einem Makroausdruck berechnet: {}</translation>
    </message>
    <message>
        <source>where this polar position is, is not known</source>
        <translation>wo diese polare Position liegt, ist nicht bekannt</translation>
    </message>
    <message>
        <source>a polar position of this motion code is not followed</source>
        <translation>eine polare Position mit diesem Bewegungscode wird nicht verfolgt</translation>
    </message>
    <message>
        <source>plain G0 to G3 moves</source>
        <translation>einfache Bewegungen G0 bis G3</translation>
    </message>
    <message>
        <source> since line {}</source>
        <translation> seit Zeile {}</translation>
    </message>
    <message>
        <source>this move cannot be corrected: {}{}; write the stretch as {}</source>
        <translation>diese Bewegung kann nicht korrigiert werden: {}{}; schreiben Sie den Abschnitt als {}</translation>
    </message>
    <message>
        <source>toolpath: its lines are not those of the program, in their order</source>
        <translation>Bahn: ihre Zeilen sind nicht die des Programms in dessen Reihenfolge</translation>
    </message>
    <message>
        <source>this move cannot be corrected: it stands in a file beside the program; put the subprogram into the program's own file</source>
        <translation>diese Bewegung kann nicht korrigiert werden: sie steht in einer Datei neben dem Programm; nehmen Sie das Unterprogramm in die Programmdatei auf</translation>
    </message>
    <message>
        <source>this line runs {} times, and its {} and {} want {}: write the runs out, each with lines of its own</source>
        <translation>dieser Satz läuft {}-mal, und {} und {} verlangen {}: schreiben Sie die Durchläufe aus, jeden mit eigenen Sätzen</translation>
    </message>
    <message>
        <source>run {}</source>
        <translation>Durchlauf {}</translation>
    </message>
    <message>
        <source> at Z{:g}</source>
        <translation> bei Z{:g}</translation>
    </message>
    <message>
        <source>other words</source>
        <translation>andere Wörter</translation>
    </message>
    <message>
        <source>other moves</source>
        <translation>andere Bewegungen</translation>
    </message>
    <message>
        <source>corrections that differ by {}</source>
        <translation>Korrekturen, die um {} auseinanderliegen</translation>
    </message>
    <message>
        <source>cannot read '{}': is this an NC program?</source>
        <translation>„{}“ ist nicht lesbar: ist das ein NC-Programm?</translation>
    </message>
    <message>
        <source>'{}' calls a label as HEIDENHAIN's ISO programs do: let the program begin with %NAME G71 or G70</source>
        <translation>„{}“ ruft ein Label auf wie DIN/ISO-Programme von HEIDENHAIN: Das Programm muss mit %NAME G71 oder G70 beginnen</translation>
    </message>
    <message>
        <source>decimal comma in '{}': write numbers with a decimal point</source>
        <translation>Dezimalkomma in „{}“: schreiben Sie Zahlen mit Dezimalpunkt</translation>
    </message>
    <message>
        <source>comment without ')': close it on the same line</source>
        <translation>Kommentar ohne „)“: schließen Sie ihn in derselben Zeile</translation>
    </message>
    <message>
        <source>'{}' is not a word: a letter needs one number behind it</source>
        <translation>„{}“ ist kein Wort: hinter einem Buchstaben steht eine Zahl</translation>
    </message>
    <message>
        <source>{} is not plain ISO code</source>
        <translation>{} ist kein einfacher ISO-Code</translation>
    </message>
    <message>
        <source>number too large: correct it</source>
        <translation>Zahl zu groß: berichtigen Sie sie</translation>
    </message>
    <message>
        <source>an O word steers the program</source>
        <translation>ein O-Wort steuert das Programm</translation>
    </message>
    <message>
        <source>{} may change the frame</source>
        <translation>{} kann das Koordinatensystem ändern</translation>
    </message>
    <message>
        <source>{} is not followed</source>
        <translation>{} wird nicht verfolgt</translation>
    </message>
    <message>
        <source>OFFN shifts the contour</source>
        <translation>OFFN verschiebt die Kontur</translation>
    </message>
    <message>
        <source>{}={}() is not followed</source>
        <translation>{}={}() wird nicht verfolgt</translation>
    </message>
    <message>
        <source>{} is computed by a macro expression</source>
        <translation>{} wird von einem Makroausdruck berechnet</translation>
    </message>
    <message>
        <source>a plain-language block among ISO code; write the program in one of both languages</source>
        <translation>ein Klartext-Satz zwischen ISO-Sätzen; das Programm in einer der beiden Sprachen schreiben</translation>
    </message>
    <message>
        <source>the program returns</source>
        <translation>das Programm springt zurück</translation>
    </message>
    <message>
        <source>variable set: {}</source>
        <translation>Variable gesetzt: {}</translation>
    </message>
    <message>
        <source>{} is assigned with '='</source>
        <translation>{} wird mit „=“ zugewiesen</translation>
    </message>
    <message>
        <source>which variable it is, is computed; state the number here</source>
        <translation>welche Variable es ist, wird berechnet; schreiben Sie hier die Zahl</translation>
    </message>
    <message>
        <source>{} is used {} times (line {}); state the numbers in these lines</source>
        <translation>{} wird {}-mal verwendet (Zeile {}); schreiben Sie in diese Zeilen die Zahlen</translation>
    </message>
    <message>
        <source>{}, set in line {},</source>
        <translation>{}, gesetzt in Zeile {},</translation>
    </message>
    <message>
        <source>the numbers of this program cannot be read; is it an NC program?</source>
        <translation>die Zahlen dieses Programms sind nicht lesbar; ist es ein NC-Programm?</translation>
    </message>
    <message>
        <source>the motion code before this line has changed: state it here</source>
        <translation>die Wegbedingung vor diesem Satz hat sich geändert: geben Sie sie hier an</translation>
    </message>
    <message>
        <source>the feed before this line has changed: state it here</source>
        <translation>der Vorschub vor dieser Zeile hat sich geändert: hier angeben</translation>
    </message>
    <message>
        <source>the position before this line has changed, but not its move: {}</source>
        <translation>die Position vor diesem Satz hat sich geändert, seine Bewegung aber nicht: {}</translation>
    </message>
    <message>
        <source>lead the cut out to a stated {} on a line before it</source>
        <translation>führen Sie den Schnitt davor in einem eigenen Satz auf ein angegebenes {} hinaus</translation>
    </message>
    <message>
        <source>state {} here</source>
        <translation>geben Sie hier {} an</translation>
    </message>
    <message>
        <source>must be {}{}</source>
        <translation>muss {}{} liegen</translation>
    </message>
    <message>
        <source>must be from {:g} to {:g}</source>
        <translation>muss zwischen {:g} und {:g} liegen</translation>
    </message>
    <message>
        <source>above {:g}</source>
        <translation>über {:g}</translation>
    </message>
    <message>
        <source>at least {:g}</source>
        <translation>mindestens {:g}</translation>
    </message>
    <message>
        <source> and at most {:g}</source>
        <translation> und höchstens {:g}</translation>
    </message>
    <message>
        <source>{}: choose one of {}</source>
        <translation>{}: wählen Sie eines von {}</translation>
    </message>
    <message>
        <source>the corrected path near {} cannot be written within {}</source>
        <translation>die korrigierte Bahn nahe {} lässt sich nicht innerhalb von {} schreiben</translation>
    </message>
    <message>
        <source>near {} the program runs {} off the profile at {} and {} off it at {}: which pass carries the correction cannot be told; correct the first, uncorrected program, or one that holds the finishing pass alone</source>
        <translation>nahe {} läuft das Programm {} neben dem Profil bei {} und {} daneben bei {}: welcher Schnitt die Korrektur trägt, ist nicht zu sagen; korrigieren Sie das erste, unkorrigierte Programm oder eines mit dem Schlichtschnitt allein</translation>
    </message>
    <message>
        <source>the written program reads back with {} moves in place of {}</source>
        <translation>das geschriebene Programm liest sich mit {} Bewegungen statt {} zurück</translation>
    </message>
    <message>
        <source>{} stays at {}: what is wanted there is too narrow for a cutter of {}; a smaller one would reach it</source>
        <translation>{} bleiben stehen bei {}: was dort gewollt ist, ist zu eng für einen Fräser von {}; ein kleinerer käme hin</translation>
    </message>
    <message>
        <source>line {} of the corrected program, which is not corrected itself, cuts {} into the corrected surface at {}, beyond what was measured: if that is a wall of the part and no lead, {} moves such passes along</source>
        <translation>Zeile {} des korrigierten Programms, die selbst nicht korrigiert ist, schneidet {} in die korrigierte Fläche bei {}, jenseits des Gemessenen: ist das eine Wand des Teils und kein Anfahren, so nimmt {} solche Schnitte mit</translation>
    </message>
    <message>
        <source>other passes on the corrected wall are moved along with it: lines {} of {}</source>
        <translation>andere Schnitte an der korrigierten Wand werden mitgenommen: Zeilen {} von {}</translation>
    </message>
    <message>
        <source>line {} of the written program goes to {} and not where it was planned to go</source>
        <translation>Zeile {} des geschriebenen Programms fährt nach {} und nicht an den geplanten Ort</translation>
    </message>
    <message>
        <source>the written program differs where it must not: its block numbers do not follow one another</source>
        <translation>das geschriebene Programm weicht ab, wo es nicht darf: seine Satznummern folgen nicht aufeinander</translation>
    </message>
    <message>
        <source>line {} of the corrected program would cut {} into another wall at {}, which line {} of the program has made and which is not corrected: measure it, too, or correct less there</source>
        <translation>Zeile {} des korrigierten Programms würde {} in eine andere Wand bei {} schneiden, die Zeile {} des Programms gemacht hat und die nicht korrigiert ist: messen Sie diese auch, oder korrigieren Sie dort weniger</translation>
    </message>
    <message>
        <source>the program does not cut the profile near {}, where points were measured: give the {} that cuts it, or only the points that belong to it</source>
        <translation>das Programm schneidet das Profil nahe {} nicht, wo Punkte gemessen sind: geben Sie das, was es schneidet, als {}, oder nur die Punkte, die dazugehören</translation>
    </message>
    <message>
        <source>no move of the program follows the profile at {}: the nearest runs {} off; check {}, {}, stock to leave and the work frame</source>
        <translation>keine Bewegung des Programms folgt dem Profil im Abstand {}: die nächste läuft {} daneben; prüfen Sie {}, {}, Aufmaß und Werkstücksystem</translation>
    </message>
    <message>
        <source>the compensated profile near {} cannot be fitted better than {}: the deviations change too fast; use a stronger {}</source>
        <translation>das korrigierte Profil nahe {} lässt sich nicht besser als auf {} annähern: die Abweichungen ändern sich zu schnell; stärkeren {} verwenden</translation>
    </message>
    <message>
        <source>the correction leaves nothing of the {} long piece of the profile near {}</source>
        <translation>die Korrektur lässt nichts übrig von dem {} langen Stück des Profils nahe {}</translation>
    </message>
    <message>
        <source>the corrected contour does not close at the corner {}</source>
        <translation>die korrigierte Kontur schließt sich an der Ecke {} nicht</translation>
    </message>
    <message>
        <source>the written program leaves no surface near {} that could be proven</source>
        <translation>das geschriebene Programm lässt nahe {} keine Fläche, die sich prüfen ließe</translation>
    </message>
    <message>
        <source>line {} of the corrected program, which is not corrected itself, would cut {} into the corrected surface at {}: it leaves too little stock for it; {} moves such passes along</source>
        <translation>Zeile {} des korrigierten Programms, die selbst nicht korrigiert ist, würde {} in die korrigierte Fläche bei {} schneiden: sie lässt zu wenig Aufmaß dafür; {} nimmt solche Schnitte mit</translation>
    </message>
    <message>
        <source>the written program differs where it must not: line {}: {}</source>
        <translation>das geschriebene Programm weicht ab, wo es nicht darf: Zeile {}: {}</translation>
    </message>
    <message>
        <source>the written program differs where it must not: line {}: its header is another one</source>
        <translation>das geschriebene Programm weicht ab, wo es nicht darf: Zeile {}: sein Kopf ist ein anderer</translation>
    </message>
    <message>
        <source>the corrected {} would be {} off at {}, more than the tolerance of {}</source>
        <translation>korrigiert (es geht um {}) läge es {} daneben bei {}, mehr als die Toleranz von {}</translation>
    </message>
    <message>
        <source>path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>{} (the cutter gouges there)</source>
        <translation>{} (der Fräser schneidet dort zu tief)</translation>
    </message>
    <message>
        <source>{}: where that does no harm, a larger {}</source>
        <translation>{}: wo es nicht schadet, ein größeres {}</translation>
    </message>
    <message>
        <source>the posted program lacks the move to {} (command {} of the path)</source>
        <translation>dem ausgegebenen Programm fehlt die Bewegung nach {} (Befehl {} der Bahn)</translation>
    </message>
    <message>
        <source>an outlier: more probably wrong than right, by its neighbours</source>
        <translation>ein Ausreißer: nach seinen Nachbarn eher falsch als richtig</translation>
    </message>
    <message>
        <source>gain {:g} leaves {:.0f} % of the determined deviation on purpose</source>
        <translation>Verstärkung {:g} lässt absichtlich {:.0f} % der ermittelten Abweichung</translation>
    </message>
    <message>
        <source>{} of {} points cannot be used, most are {}: see the report for which</source>
        <translation>{} von {} Punkten sind nicht brauchbar, die meisten: {}; welche, steht im Bericht</translation>
    </message>
    <message>
        <source>a tool's diameter {} for {}</source>
        <translation>ein Werkzeugdurchmesser {} statt {}</translation>
    </message>
    <message>
        <source>mean {} all along, form only {}: check for {}; else the machine gives way</source>
        <translation>Mittel {} überall, Form nur {}: prüfen Sie auf {}; sonst gibt die Maschine nach</translation>
    </message>
    <message>
        <source>sides that lie {} off the other {} all along (each within {}): {}, the first at {}; compare that dimension with the drawing: another revision, or a wall that gives way</source>
        <translation>Seiten, die durchweg {} von den anderen {} abliegen (jede auf {} gleich): {}, die erste bei {}; vergleichen Sie das Maß mit der Zeichnung: ein anderer Stand, oder eine nachgebende Wand</translation>
    </message>
    <message>
        <source>only {} of {} points can be used, most others are {}: is the program whole, and is it the one that cut the part?</source>
        <translation>nur {} von {} Punkten sind brauchbar, die meisten anderen: {}; ist das Programm vollständig, und hat es das Teil geschnitten?</translation>
    </message>
    <message>
        <source>check the height of the work frame of the measurement</source>
        <translation>prüfen Sie die Höhe des Werkstücksystems der Messung</translation>
    </message>
    <message>
        <source>{} of {} points on the profile ({} to {}) lie {} all that the program cuts, {}: {}, or leave the column z out</source>
        <translation>{} von {} Punkten am Profil ({} bis {}) liegen {} allem, was das Programm schneidet, {}: {}, oder lassen Sie die Spalte z weg</translation>
    </message>
    <message>
        <source>{} points (from {}) lie below the deepest pass at {}: {}</source>
        <translation>{} Punkte (ab {}) liegen unter dem tiefsten Schnitt bei {}: {}</translation>
    </message>
    <message>
        <source>{} points (up to {}) lie above {}, from where the cutter comes down: {}</source>
        <translation>{} Punkte (bis {}) liegen über {}, von wo der Fräser herunterkommt: {}</translation>
    </message>
    <message>
        <source>a probe's radius {} for {}</source>
        <translation>ein Tasterradius {} statt {}</translation>
    </message>
    <message>
        <source>steel measured {:.0f} K too warm</source>
        <translation>Stahl {:.0f} K zu warm gemessen</translation>
    </message>
    <message>
        <source>{:.0f} % of the deviations are what a shift of X{} Y{} and a turn of {:+.0f} arc seconds would give: check the alignment of the measurement ({}), or correct the work offset</source>
        <translation>{:.0f} % der Abweichungen sind, was eine Verschiebung X{} Y{} und eine Drehung um {:+.0f} Bogensekunden ergäben: prüfen Sie die Ausrichtung der Messung ({}), oder berichtigen Sie die Nullpunktverschiebung</translation>
    </message>
    <message>
        <source>{:.0f} % of the deviations are what a size of {:.6f} times the profile's would give ({} at the rim; steel grows by 11.5 millionths a degree): check temperature, unit and scale of the measurement; no scale is ever applied</source>
        <translation>{:.0f} % der Abweichungen sind, was das {:.6f}-Fache der Größe des Profils ergäbe ({} am Rand; Stahl wächst je Grad um 11,5 Millionstel): prüfen Sie Temperatur, Einheit und Maßstab der Messung; ein Maßstab wird nie angewandt</translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation>{} bis {}</translation>
    </message>
    <message>
        <source>{} up</source>
        <translation>{} aufwärts</translation>
    </message>
    <message>
        <source>below</source>
        <translation>unter</translation>
    </message>
    <message>
        <source>above</source>
        <translation>über</translation>
    </message>
    <message>
        <source>a probe's radius {} too small</source>
        <translation>ein um {} zu kleiner Tasterradius</translation>
    </message>
    <message>
        <source>a probe's radius {} too large</source>
        <translation>ein um {} zu großer Tasterradius</translation>
    </message>
    <message>
        <source>{} of stock left</source>
        <translation>{} stehengebliebenes Aufmaß</translation>
    </message>
    <message>
        <source>times 25.4</source>
        <translation>mal 25,4</translation>
    </message>
    <message>
        <source>divided by 25.4</source>
        <translation>geteilt durch 25,4</translation>
    </message>
    <message>
        <source>with z reversed</source>
        <translation>mit umgekehrtem z</translation>
    </message>
    <message>
        <source>{} they would lie there; check the unit of z and the height of the work frame</source>
        <translation>{} lägen sie dort; prüfen Sie die Einheit von z und die Höhe des Werkstücksystems</translation>
    </message>
    <message>
        <source>steel measured {:.0f} K too cold</source>
        <translation>Stahl {:.0f} K zu kalt gemessen</translation>
    </message>
    <message>
        <source>{}: the nominal was probably exported in place of the measured points; export the actual points, to 0.0001 mm</source>
        <translation>{}: wahrscheinlich wurde die Sollkontur statt der gemessenen Punkte ausgegeben; geben Sie die Istpunkte aus, auf 0,0001 mm</translation>
    </message>
    <message>
        <source>{} states a deviation of {}, its points give {} ({} of {} disagree): {}; leave the column of deviations out, or correct it</source>
        <translation>{} nennt eine Abweichung von {}, ihre Punkte ergeben {} ({} von {} widersprechen sich): {}; lassen Sie die Spalte der Abweichungen weg, oder berichtigen Sie sie</translation>
    </message>
    <message>
        <source>the {} points are a height map, touched along Z: they show nothing of a contour; touch its walls with a measuring program</source>
        <translation>die {} Punkte sind eine Höhenkarte, entlang Z angetastet: sie zeigen nichts von einer Kontur; tasten Sie deren Wände an, mit einem Messprogramm</translation>
    </message>
    <message>
        <source>a ball of radius {} is on no touch probe ({} to {})</source>
        <translation>eine Kugel vom Radius {} sitzt an keinem Taster ({} bis {})</translation>
    </message>
    <message>
        <source>the points extend over {}, and the file does not say its unit: {}? Say {} if it is right, {}, or export in mm</source>
        <translation>die Punkte erstrecken sich über {}, und die Datei nennt ihre Einheit nicht: {}? Sagen Sie {}, wenn es stimmt, {}, oder geben Sie in mm aus</translation>
    </message>
    <message>
        <source>the coordinates are given in steps of {}, which alone scatters deviations by {} (standard deviation): export to 0.0001 mm</source>
        <translation>die Koordinaten sind in Schritten von {} angegeben, was allein die Abweichungen um {} streut (Standardabweichung): geben Sie auf 0,0001 mm aus</translation>
    </message>
    <message>
        <source>every deviation is 0</source>
        <translation>jede Abweichung ist 0</translation>
    </message>
    <message>
        <source>no deviation is larger than {}, what rounding to {} alone makes</source>
        <translation>keine Abweichung ist größer als {}, was schon das Runden auf {} ergibt</translation>
    </message>
    <message>
        <source>its sign is the other way round, positive into the material</source>
        <translation>ihr Vorzeichen ist umgekehrt, positiv ins Material</translation>
    </message>
    <message>
        <source>check what its columns mean</source>
        <translation>prüfen Sie, was ihre Spalten bedeuten</translation>
    </message>
    <message>
        <source>{}; {:.4g} inch are {}, and the file does not say its unit: {}</source>
        <translation>{}; {:.4g} Zoll sind {}, und die Datei nennt ihre Einheit nicht: {}</translation>
    </message>
    <message>
        <source>{}: {} takes a radius in mm</source>
        <translation>{}: {} ist ein Radius in mm</translation>
    </message>
    <message>
        <source>metres or inches</source>
        <translation>Meter oder Zoll</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>Mikrometer</translation>
    </message>
    <message>
        <source>{}: there is no such finding; known are {}</source>
        <translation>{}: so einen Befund gibt es nicht; bekannt sind {}</translation>
    </message>
    <message>
        <source>accepted {}: {}</source>
        <translation>{} angenommen: {}</translation>
    </message>
    <message>
        <source>the part shows {:.0f} % of just the errors (up to {}) that the program takes away already, {:.0f} % of its deviations: was it cut with this program, and not with the earlier one? Measure a part cut with this program, or give the program that cut this one</source>
        <translation>das Teil zeigt {:.0f} % gerade der Fehler (bis {}), die das Programm schon wegnimmt, {:.0f} % seiner Abweichungen: wurde es mit diesem Programm geschnitten und nicht mit dem früheren? Messen Sie ein Teil von diesem Programm, oder geben Sie das Programm, das dieses geschnitten hat</translation>
    </message>
    <message>
        <source>{:.0f} % of the points of {} lie where {} has none, and only places of the first part tell the transfer function: name first the part that was measured all round ({})</source>
        <translation>{:.0f} % der Punkte von {} liegen, wo {} keine hat, und nur Stellen des ersten Teils geben die Übertragungsfunktion: nennen Sie zuerst das rundum gemessene Teil ({})</translation>
    </message>
    <message>
        <source>{:.0f} % of the points of {} lie within {} of those of {}: the same part again, and no mean of two; give each part once</source>
        <translation>{:.0f} % der Punkte von {} liegen auf {} bei denen von {}: noch einmal dasselbe Teil und kein Mittel von zweien; geben Sie jedes Teil einmal</translation>
    </message>
    <message>
        <source>the file's own nominal points lie {} off the profile: check {}, the operation and the work frame</source>
        <translation>die eigenen Sollpunkte der Datei liegen {} neben dem Profil: prüfen Sie {}, die Operation und das Werkstücksystem</translation>
    </message>
    <message>
        <source>the normals of {} of {} points point into the material: export normals out of the material, not directions of approach</source>
        <translation>die Normalen von {} der {} Punkte zeigen ins Material: geben Sie Normalen aus dem Material heraus aus, nicht Antastrichtungen</translation>
    </message>
    <message>
        <source>points on thin walls that lie so far off that the other side may be meant: {}, the thinnest wall {} ({}, {}); the file has no normals: export normals</source>
        <translation>Punkte an dünnen Wänden, so weit daneben, dass die andere Seite gemeint sein kann: {}, die dünnste Wand {} ({}, {}); die Datei hat keine Normalen: geben Sie Normalen aus</translation>
    </message>
    <message>
        <source>mirror the work frame of the measurement</source>
        <translation>spiegeln Sie das Werkstücksystem der Messung</translation>
    </message>
    <message>
        <source>turn the work frame of the measurement back</source>
        <translation>drehen Sie das Werkstücksystem der Messung zurück</translation>
    </message>
    <message>
        <source>the points lie {} off {} all along, with only {} of scatter</source>
        <translation>die Punkte liegen durchweg {} neben {}, mit nur {} Streuung</translation>
    </message>
    <message>
        <source>the surface {} over the profile</source>
        <translation>der Fläche {} über dem Profil</translation>
    </message>
    <message>
        <source>the profile</source>
        <translation>dem Profil</translation>
    </message>
    <message>
        <source>{}: {} seems to be the diameter: {}</source>
        <translation>{}: {} scheint der Durchmesser zu sein: {}</translation>
    </message>
    <message>
        <source>{}: {} seems to be half of what it should be: {}</source>
        <translation>{}: {} scheint die Hälfte des Richtigen zu sein: {}</translation>
    </message>
    <message>
        <source>{}, the cutter's diameter: the profile was taken on the wrong side of the path: {}</source>
        <translation>{}, der Durchmesser des Fräsers: das Profil wurde auf der falschen Seite der Bahn genommen: {}</translation>
    </message>
    <message>
        <source>{}: what a transfer function of {:.3f} leaves of {}</source>
        <translation>{}: was eine Übertragungsfunktion von {:.3f} von {} stehen lässt</translation>
    </message>
    <message>
        <source>{}: check {}, by this {} were left, and {} and {}</source>
        <translation>{}: prüfen Sie {}, danach wären {} stehengeblieben, und {} und {}</translation>
    </message>
    <message>
        <source>{}: they look like centres of a ball of about that radius: {} with the radius from the probe's calibration; or stock was left there ({}), or the tool differs from {}</source>
        <translation>{}: sie sehen aus wie Mittelpunkte einer Kugel von etwa diesem Radius: {} mit dem Radius aus der Kalibrierung des Tasters; oder dort blieb Aufmaß stehen ({}), oder das Werkzeug ist anders als {}</translation>
    </message>
    <message>
        <source>{}: check {}, {} (stock left on the part), {} and the work frame</source>
        <translation>{}: prüfen Sie {}, {} (am Teil gelassenes Aufmaß), {} und das Werkstücksystem</translation>
    </message>
    <message>
        <source>{}: check {}, {} and the work frame</source>
        <translation>{}: prüfen Sie {}, {} und das Werkstücksystem</translation>
    </message>
    <message>
        <source>times {:g}</source>
        <translation>mal {:g}</translation>
    </message>
    <message>
        <source>the file is in inches: {}</source>
        <translation>die Datei ist in Zoll: {}</translation>
    </message>
    <message>
        <source>divided by {:g}</source>
        <translation>geteilt durch {:g}</translation>
    </message>
    <message>
        <source>the file is in millimetres or was converted twice: {}</source>
        <translation>die Datei ist in Millimetern oder wurde zweimal umgerechnet: {}</translation>
    </message>
    <message>
        <source>with x reversed</source>
        <translation>mit umgekehrtem x</translation>
    </message>
    <message>
        <source>with y reversed</source>
        <translation>mit umgekehrtem y</translation>
    </message>
    <message>
        <source>with x and y exchanged</source>
        <translation>mit vertauschten x und y</translation>
    </message>
    <message>
        <source>exchange the columns x and y</source>
        <translation>vertauschen Sie die Spalten x und y</translation>
    </message>
    <message>
        <source>with x and y exchanged and reversed</source>
        <translation>mit vertauschten und umgekehrten x und y</translation>
    </message>
    <message>
        <source>turned by {} degrees</source>
        <translation>um {} Grad gedreht</translation>
    </message>
    <message>
        <source>{:.0f} % of the points lie on the profile, but {} {:.0f} %</source>
        <translation>{:.0f} % der Punkte liegen am Profil, aber {} {:.0f} %</translation>
    </message>
    <message>
        <source>{}: they are contact points already: {}</source>
        <translation>{}: es sind schon Berührpunkte: {}</translation>
    </message>
    <message>
        <source>{}; check {} if that seems much</source>
        <translation>{}; prüfen Sie {}, wenn das viel scheint</translation>
    </message>
    <message>
        <source>the points lie typically {} off the profile, but {} {}</source>
        <translation>die Punkte liegen meist {} neben dem Profil, aber {} {}</translation>
    </message>
    <message>
        <source>{:.0f} % of the contour has no measured point near, most of it between {} and {}: measure there, or say with {} how much may be left to the mean</source>
        <translation>{:.0f} % der Kontur haben keinen gemessenen Punkt in der Nähe, das meiste zwischen {} und {}: messen Sie dort, oder sagen Sie mit {}, wie viel dem Mittel überlassen wird</translation>
    </message>
    <message>
        <source>{} of {} points are outliers: clean the part and the probe, measure again</source>
        <translation>{} von {} Punkten sind Ausreißer: reinigen Sie Teil und Taster und messen Sie neu</translation>
    </message>
    <message>
        <source>the wall leans: at {} it has {} more than at {} {}; one path corrects the mean of the heights: a spring pass or less overhang of the tool takes the lean away</source>
        <translation>die Wand ist schief: bei {} hat sie {} mehr als bei {} {}; eine Bahn korrigiert das Mittel der Höhen: ein Leerschnitt oder weniger Auskragung des Werkzeugs nimmt die Schräge weg</translation>
    </message>
    <message>
        <source>{} of {} points are outliers, the first at {}: clean the part and the probe, measure again</source>
        <translation>{} von {} Punkten sind Ausreißer, der erste bei {}: reinigen Sie Teil und Taster und messen Sie neu</translation>
    </message>
    <message>
        <source>all along</source>
        <translation>überall</translation>
    </message>
    <message>
        <source>at {}, {} on the average</source>
        <translation>bei {}, {} im Mittel</translation>
    </message>
    <message>
        <source>the ball leaves the space that the program clears, first near {}: make sure that nothing stands there, or say how far it is free with {} and lower {}</source>
        <translation>die Kugel verlässt den Raum, den das Programm freiräumt, zuerst nahe {}: stellen Sie sicher, dass dort nichts steht, oder geben Sie mit {} an, wie weit es frei ist, und verringern Sie {}</translation>
    </message>
    <message>
        <source>{} is one of {}, not {!r}</source>
        <translation>{} ist eines von {}, nicht {!r}</translation>
    </message>
    <message>
        <source>the model has no wall on this contour: heights are judged by the passes only</source>
        <translation>das Modell hat keine Wand an dieser Kontur: Höhen werden nur nach den Bahnen beurteilt</translation>
    </message>
    <message>
        <source>nothing shows that the wall stands as high as {}: the highest pass beside it runs at {}</source>
        <translation>nichts zeigt, dass die Wand bis {} hinaufreicht: die höchste Bahn daneben läuft auf {}</translation>
    </message>
    <message>
        <source>this height is right only for a probe whose length was set to the tip of the ball, not to its centre</source>
        <translation>diese Höhe stimmt nur für einen Taster, dessen Länge auf die unterste Stelle der Kugel eingestellt wurde, nicht auf ihre Mitte</translation>
    </message>
    <message>
        <source>this height is right only for a probe whose length was set to the centre of the ball, not to its tip</source>
        <translation>diese Höhe stimmt nur für einen Taster, dessen Länge auf die Mitte der Kugel eingestellt wurde, nicht auf ihre unterste Stelle</translation>
    </message>
    <message>
        <source>{}: GRBL writes no file, save the log of the sender</source>
        <translation>{}: GRBL schreibt keine Datei, speichern Sie das Protokoll des Senders</translation>
    </message>
    <message>
        <source>{}: GRBL changes no tools, leave it out</source>
        <translation>{}: GRBL wechselt keine Werkzeuge, lassen Sie es weg</translation>
    </message>
    <message>
        <source>{} touches, {} of {} ways between them over the safe height</source>
        <translation>{} Berührungen, {} von {} Wegen dazwischen über die sichere Höhe</translation>
    </message>
    <message>
        <source>measured at {}, passed over at {}</source>
        <translation>gemessen auf {}, überfahren auf {}</translation>
    </message>
    <message>
        <source>{}: this control takes names like {}</source>
        <translation>{}: diese Steuerung nimmt Namen wie {}</translation>
    </message>
    <message>
        <source>program name {!r}: this control takes names like {}</source>
        <translation>Programmname {!r}: diese Steuerung nimmt Namen wie {}</translation>
    </message>
    <message>
        <source>{} and {} are no heights in mm</source>
        <translation>{} und {} sind keine Höhen in mm</translation>
    </message>
    <message>
        <source>{} must lie above {}</source>
        <translation>{} muss über {} liegen</translation>
    </message>
    <message>
        <source>{} is no tool number</source>
        <translation>{} ist keine Werkzeugnummer</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>heights</source>
        <translation>Höhen</translation>
    </message>
    <message>
        <source>{} and {} more</source>
        <translation>{} und {} weitere</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>{} is no feed in mm/min</source>
        <translation>{} ist kein Vorschub in mm/min</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>{}: where DPRNT writes is set on the {} control</source>
        <translation>{}: wohin DPRNT schreibt, wird an der Steuerung {} eingestellt</translation>
    </message>
    <message>
        <source>{} lies below {}, a margin of {} above the deepest that the program cuts beside the contour: say {} or higher</source>
        <translation>{} liegt unter {}, einem Abstand von {} über dem Tiefsten, das das Programm neben der Kontur schneidet: geben Sie {} oder mehr an</translation>
    </message>
    <message>
        <source>the program's lowest rapid across the part</source>
        <translation>dem tiefsten Eilgang des Programms über das Teil</translation>
    </message>
    <message>
        <source>the program's highest cut</source>
        <translation>dem höchsten Schnitt des Programms</translation>
    </message>
    <message>
        <source>the top of the model and the ball above it</source>
        <translation>der Oberkante des Modells und der Kugel darüber</translation>
    </message>
    <message>
        <source>{} lies below {}, {}: say {} or higher</source>
        <translation>{} liegt unter {}, {}: geben Sie {} oder mehr an</translation>
    </message>
    <message>
        <source>the ball does not reach it: the contour is too hollow there, or another wall is too near</source>
        <translation>die Kugel kommt nicht hin: die Kontur ist dort zu hohl, oder eine andere Wand ist zu nah</translation>
    </message>
    <message>
        <source>the cutter does not reach it: its fillet stands there</source>
        <translation>der Fräser kommt nicht hin: dort steht seine Ausrundung</translation>
    </message>
    <message>
        <source>another wall is in the way of the touch</source>
        <translation>eine andere Wand ist der Antastung im Weg</translation>
    </message>
    <message>
        <source>no wall stands there that is as high, and cut as deep, as the ball needs it</source>
        <translation>dort steht keine Wand, die so hoch und so tief geschnitten ist, wie die Kugel sie braucht</translation>
    </message>
    <message>
        <source>there is no room for the ball to stand clear before the touch</source>
        <translation>vor der Antastung ist kein Platz, an dem die Kugel frei stünde</translation>
    </message>
    <message>
        <source>near {} {}</source>
        <translation>nahe {}: {}</translation>
    </message>
    <message>
        <source>no stretch</source>
        <translation>kein Abschnitt</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} und {}</translation>
    </message>
    <message>
        <source>no point of the contour can be touched: {}; check {}</source>
        <translation>kein Punkt der Kontur kann angetastet werden: {}; prüfen Sie {}</translation>
    </message>
    <message>
        <source>the stretch of {} between corners is shorter than {}</source>
        <translation>der Abschnitt von {} zwischen Ecken ist kürzer als {}</translation>
    </message>
    <message>
        <source>no point of the contour can be touched: {} near {}; use a smaller ball</source>
        <translation>kein Punkt der Kontur kann angetastet werden: {} nahe {}; nehmen Sie eine kleinere Kugel</translation>
    </message>
    <message>
        <source>{} makes more than {} points</source>
        <translation>{} ergibt mehr als {} Punkte</translation>
    </message>
    <message>
        <source>the margin {:g} at corners must lie between 0 and 1000 mm</source>
        <translation>der Abstand {:g} an Ecken muss zwischen 0 und 1000 mm liegen</translation>
    </message>
    <message>
        <source>{}: the ball and the stock do not fit in there</source>
        <translation>{}: Kugel und Aufmaß haben darin keinen Platz</translation>
    </message>
    <message>
        <source>give either {} or {}</source>
        <translation>geben Sie entweder {} oder {} an</translation>
    </message>
    <message>
        <source>{} must lie between 1 and {}</source>
        <translation>{} muss zwischen 1 und {} liegen</translation>
    </message>
    <message>
        <source>{} is no distance in mm</source>
        <translation>{} ist kein Abstand in mm</translation>
    </message>
    <message>
        <source>{}: the profile has {} contours</source>
        <translation>{}: das Profil hat {} Konturen</translation>
    </message>
    <message>
        <source>{}: there are {} smooth stretches</source>
        <translation>{}: es gibt {} glatte Abschnitte</translation>
    </message>
    <message>
        <source>{} must lie between {:g} and 1000 mm</source>
        <translation>{} muss zwischen {:g} und 1000 mm liegen</translation>
    </message>
    <message>
        <source>cutting: the move that cuts at {} has no feed in mm/min: state F in G94</source>
        <translation>Zerspanung: der schneidende Weg bei {} hat keinen Vorschub in mm/min: geben Sie F in G94 an</translation>
    </message>
    <message>
        <source>setup: [tool] overhang_mm is missing: how the tool bends along its height needs it</source>
        <translation>Einrichtung: [tool] overhang_mm fehlt: wie sich das Werkzeug über die Höhe biegt, hängt davon ab</translation>
    </message>
    <message>
        <source>{}: [machine] stiffness_along has {:g} N/mm, of the whole loop, tool included, but the tool alone has {:.0f} N/mm at its tip: correct [tool] overhang_mm, youngs_modulus_gpa or stiffness_n_per_mm</source>
        <translation>{}: [machine] stiffness_along hat {:g} N/mm für den ganzen Kraftfluss samt Werkzeug, aber das Werkzeug allein hat {:.0f} N/mm an der Spitze: berichtigen Sie [tool] overhang_mm, youngs_modulus_gpa oder stiffness_n_per_mm</translation>
    </message>
    <message>
        <source>setup: [machine] {} {:g} N/mm is of the whole loop, tool included, but the tool alone has {:.0f} N/mm at its tip: correct [tool] overhang_mm, youngs_modulus_gpa or stiffness_n_per_mm, or leave the key out for a rigid machine</source>
        <translation>Einrichtung: [machine] {} {:g} N/mm gilt für den ganzen Kraftfluss samt Werkzeug, aber das Werkzeug allein hat {:.0f} N/mm an der Spitze: berichtigen Sie [tool] overhang_mm, youngs_modulus_gpa oder stiffness_n_per_mm, oder lassen Sie den Schlüssel für eine starre Maschine weg</translation>
    </message>
    <message>
        <source>predicted deviation: the path cuts away again all that it makes</source>
        <translation>vorhergesagte Abweichung: die Bahn schneidet alles wieder weg, was sie erzeugt</translation>
    </message>
    <message>
        <source>wall error: the deflection does not settle near {}, it still changes by {}; check [tool] overhang_mm, [material] and the radial depth of cut</source>
        <translation>Wandfehler: die Verformung kommt nahe {} nicht zur Ruhe, sie ändert sich noch um {}; prüfen Sie [tool] overhang_mm, [material] und die radiale Schnitttiefe</translation>
    </message>
    <message>
        <source>wall error: the program makes no wall: it cuts only slots or air</source>
        <translation>Wandfehler: das Programm macht keine Wand: es schneidet nur Nuten oder Luft</translation>
    </message>
    <message>
        <source>wall error: the program makes no wall {} above its deepest tip</source>
        <translation>Wandfehler: das Programm macht keine Wand {} über seiner tiefsten Spitze</translation>
    </message>
    <message>
        <source>{}: no move cuts in the XY plane at constant height</source>
        <translation>{}: kein Weg schneidet in der XY-Ebene auf gleicher Höhe</translation>
    </message>
    <message>
        <source>{}: no move that cuts in the XY plane can be followed</source>
        <translation>{}: keinem Weg, der in der XY-Ebene schneidet, ist zu folgen</translation>
    </message>
    <message>
        <source>tilt: the slope of the wall needs two heights at least</source>
        <translation>Neigung: die Steigung der Wand braucht mindestens zwei Höhen</translation>
    </message>
    <message>
        <source>tilt: the program makes no wall within {} of the nominal: check {}</source>
        <translation>Neigung: das Programm macht keine Wand innerhalb von {} am Nennprofil: prüfen Sie {}</translation>
    </message>
    <message>
        <source>mean shift: the program makes no wall within {} of the nominal: check {}</source>
        <translation>mittlere Verschiebung: das Programm macht keine Wand innerhalb von {} am Nennprofil: prüfen Sie {}</translation>
    </message>
    <message>
        <source>tilt: the walls are cut in passes of several depths: only walls of one depth are tilted</source>
        <translation>Neigung: die Wände werden in Bahnen mehrerer Tiefen geschnitten: nur Wände einer Tiefe werden geneigt</translation>
    </message>
    <message>
        <source>tilt: a stretch is cut at fewer than two of the heights: give heights within its depth</source>
        <translation>Neigung: ein Abschnitt wird auf weniger als zwei der Höhen geschnitten: geben Sie Höhen innerhalb seiner Tiefe an</translation>
    </message>
    <message>
        <source>stretch {} ({}): at most {} off over the heights; shift {}: {}; shift and tilt {:+.4f} deg: {}, and the tilted end face digs {} below the tip</source>
        <translation>Abschnitt {} ({}): höchstens {} Fehler über die Höhen; Verschiebung {}: {}; Verschiebung und Neigung {:+.4f}°: {}, und die geneigte Stirn gräbt {} unter die Spitze</translation>
    </message>
    <message>
        <source>{}: the program cuts with G41 or G42, so it does not say where the cutter's centre goes: give a program of the centre path</source>
        <translation>{}: das Programm schneidet mit G41 oder G42 und sagt daher nicht, wo die Fräsermitte läuft: geben Sie ein Programm der Mittelpunktsbahn</translation>
    </message>
    <message>
        <source>{}: engagement needs arcs in the XY plane (G17); the program has others that cut</source>
        <translation>{}: der Eingriff braucht Bögen in der XY-Ebene (G17); das Programm hat andere, die schneiden</translation>
    </message>
    <message>
        <source>{}: line {} cuts from a place the program has not stated: state X and Y before it</source>
        <translation>{}: Zeile {} schneidet von einem Ort aus, den das Programm nicht angegeben hat: geben Sie davor X und Y an</translation>
    </message>
    <message>
        <source>the curve near {} bends too sharply to be followed</source>
        <translation>die Kurve bei {} ist zu stark gekrümmt, um ihr zu folgen</translation>
    </message>
    <message>
        <source>load ratio: the cutter takes nothing at {}, where the part was touched</source>
        <translation>Lastverhältnis: der Fräser nimmt bei {} nichts ab, wo das Teil angetastet wurde</translation>
    </message>
    <message>
        <source>load ratio: the program cuts only air</source>
        <translation>Lastverhältnis: das Programm schneidet nur Luft</translation>
    </message>
    <message>
        <source>engagement: the program states no Z: give [stock] axial_depth_mm in place of top_z_mm</source>
        <translation>Eingriff: das Programm gibt kein Z an: geben Sie [stock] axial_depth_mm statt top_z_mm</translation>
    </message>
    <message>
        <source>engagement: the program stays above the stock's face at {}: check [stock] top_z_mm</source>
        <translation>Eingriff: das Programm bleibt über der Rohteilfläche bei {}: prüfen Sie [stock] top_z_mm</translation>
    </message>
    <message>
        <source>engagement: the program cuts at {} heights, more than {}: it is no flank milling</source>
        <translation>Eingriff: das Programm schneidet auf {} Höhen, mehr als {}: das ist kein Flankenfräsen</translation>
    </message>
    <message>
        <source>engagement: the program cuts with several tools ({}): give the moves of one</source>
        <translation>Eingriff: das Programm schneidet mit mehreren Werkzeugen ({}): geben Sie die Wege von einem</translation>
    </message>
    <message>
        <source>engagement: the program has no cutting move in the XY plane</source>
        <translation>Eingriff: das Programm hat keinen schneidenden Weg in der XY-Ebene</translation>
    </message>
    <message>
        <source>setup: [stock] allowance_mm needs the nominal profile it lies on</source>
        <translation>Einrichtung: [stock] allowance_mm braucht das Sollprofil, auf dem es liegt</translation>
    </message>
    <message>
        <source>acc/dec time {:g} s: state 0, or {:g} s or more</source>
        <translation>Beschleunigungszeit {:g} s: geben Sie 0 an, oder {:g} s oder mehr</translation>
    </message>
    <message>
        <source>servo gain {:g} 1/s: state a gain above 0 up to {:g}, or leave it out for an ideal servo</source>
        <translation>Kv-Faktor {:g} 1/s: geben Sie einen über 0 bis {:g} an, oder lassen Sie ihn für einen idealen Antrieb weg</translation>
    </message>
    <message>
        <source>rapid speed {:g} mm/s: state a speed above 0, or leave it out</source>
        <translation>Eilgang {:g} mm/s: geben Sie eine Geschwindigkeit über 0 an, oder lassen Sie ihn weg</translation>
    </message>
    <message>
        <source>speed change at corners {:g} mm/s: state a speed above 0</source>
        <translation>Geschwindigkeitssprung an Ecken {:g} mm/s: geben Sie eine Geschwindigkeit über 0 an</translation>
    </message>
    <message>
        <source>accuracy-maintenance time: slope and intercept are 0 or more, and not both 0</source>
        <translation>Zeit zum Halten der Genauigkeit: Steigung und Achsenabschnitt sind 0 oder mehr, und nicht beide 0</translation>
    </message>
    <message>
        <source>in-position width {}: state a width above 0</source>
        <translation>Positionierfenster {}: geben Sie eine Breite über 0 an</translation>
    </message>
    <message>
        <source>this dwell cannot be read: state one of P, X or U</source>
        <translation>diese Verweilzeit ist nicht zu lesen: geben Sie eines von P, X oder U an</translation>
    </message>
    <message>
        <source>controls differ on whether {}{:g} are seconds or milliseconds: state the unit of dwells</source>
        <translation>Steuerungen verstehen {}{:g} verschieden, als Sekunden oder Millisekunden: geben Sie die Einheit der Verweilzeiten an</translation>
    </message>
    <message>
        <source>line {}: this curve bends too sharply to be followed; write it as lines or arcs</source>
        <translation>Zeile {}: diese Kurve ist zu stark gekrümmt, um ihr zu folgen; schreiben Sie sie als Geraden oder Bögen</translation>
    </message>
    <message>
        <source>{}: no move can be followed</source>
        <translation>{}: keinem Weg ist zu folgen</translation>
    </message>
    <message>
        <source>combined control: no stiffness makes the model leave what was touched, {} are still missing: check {}, [stock] and [material]</source>
        <translation>kombiniert: mit keiner Steifigkeit lässt das Modell, was angetastet wurde, {} fehlen noch: prüfen Sie {}, [stock] und [material]</translation>
    </message>
    <message>
        <source>at {} a point was touched where the program takes nothing off the stock of the setup: check [stock] and {}</source>
        <translation>bei {} wurde ein Punkt angetastet, an dem das Programm nichts vom Rohteil der Einrichtung abnimmt: prüfen Sie [stock] und {}</translation>
    </message>
    <message>
        <source>at {} {} of a depth of {} stayed: MS = delta/(h - delta) has no meaning there; check {} or [stock]</source>
        <translation>bei {} blieben {} einer Tiefe von {} stehen: MS = delta/(h - delta) hat dort keinen Sinn; prüfen Sie {} oder [stock]</translation>
    </message>
    <message>
        <source>combined control: the model has no force across the walls that were touched</source>
        <translation>kombiniert: das Modell hat keine Kraft quer zu den angetasteten Wänden</translation>
    </message>
    <message>
        <source>combined control: the touches show the cutter moved against the force of the model (mean deviation {}): check [tool] rotation, the cutter's side and {}; or take the deviations as they are: {}</source>
        <translation>kombiniert: die Antastungen zeigen den Fräser gegen die Kraft des Modells verschoben (mittlere Abweichung {}): prüfen Sie [tool] rotation, die Seite des Fräsers und {}; oder nehmen Sie die Abweichungen, wie sie sind: {}</translation>
    </message>
    <message>
        <source>corner bound {}: state a length above 0</source>
        <translation>Eckenfehler {}: geben Sie eine Länge über 0 an</translation>
    </message>
    <message>
        <source>{}:{}: the corner is off by {} and cannot be slowed: {}; lower the feed there, raise the bound, or accept it as it is</source>
        <translation>{}:{}: die Ecke weicht um {} ab und kann nicht verlangsamt werden: {}; senken Sie dort den Vorschub, erlauben Sie mehr, oder nehmen Sie es hin</translation>
    </message>
    <message>
        <source>{}:{}: the slowed corner is still off by {}, more than {}</source>
        <translation>{}:{}: die verlangsamte Ecke weicht noch um {} ab, mehr als {}</translation>
    </message>
    <message>
        <source>one of its blocks is a spline</source>
        <translation>einer ihrer Sätze ist ein Spline</translation>
    </message>
    <message>
        <source>the feed would be below the smallest step of a feed</source>
        <translation>der Vorschub läge unter dem kleinsten Schritt eines Vorschubs</translation>
    </message>
    <message>
        <source>{}: the slowed program does not read back as it was meant; raise the bound</source>
        <translation>{}: das verlangsamte Programm liest sich nicht so zurück, wie es gemeint war; erlauben Sie mehr</translation>
    </message>
    <message>
        <source>its blocks are too short for the control to change the feed in them</source>
        <translation>ihre Sätze sind zu kurz, als dass die Steuerung den Vorschub darin ändern könnte</translation>
    </message>
    <message>
        <source>its error does not fall with the feed</source>
        <translation>ihr Fehler sinkt nicht mit dem Vorschub</translation>
    </message>
    <message>
        <source>{}: a corner is lost in the slowed program; raise the bound</source>
        <translation>{}: im verlangsamten Programm ging eine Ecke verloren; erlauben Sie mehr</translation>
    </message>
    <message>
        <source>elastic loop: it does not settle near {}, where force and deflection still differ by {}; check [machine] stiffness, feed and [material]</source>
        <translation>elastischer Kreis: er kommt nahe {} nicht zur Ruhe, wo Kraft und Verformung noch um {} auseinanderliegen; prüfen Sie Steifigkeit [machine], Vorschub und [material]</translation>
    </message>
    <message>
        <source>elastic loop: the cut is {:.2f} times as stiff as the machine ({:g} N/mm): it need not settle; check [machine] kx_n_per_mm and ky_n_per_mm, feed, axial depth and [material]</source>
        <translation>elastischer Kreis: der Schnitt ist {:.2f}-mal so steif wie die Maschine ({:g} N/mm): er muss nicht zur Ruhe kommen; prüfen Sie [machine] kx_n_per_mm und ky_n_per_mm, Vorschub, axiale Tiefe und [material]</translation>
    </message>
    <message>
        <source>predicted deviation: a spacing of {!r} mm is not positive</source>
        <translation>vorhergesagte Abweichung: ein Abstand von {!r} mm ist nicht positiv</translation>
    </message>
    <message>
        <source>predicted deviation: the program does not cut the nominal profile: check both</source>
        <translation>vorhergesagte Abweichung: das Programm schneidet das Nennprofil nicht: prüfen Sie beide</translation>
    </message>
    <message>
        <source>predicted deviation: nothing cuts at or below {}</source>
        <translation>vorhergesagte Abweichung: nichts schneidet auf oder unter {}</translation>
    </message>
    <message>
        <source>predicted deviation: what the cutter leaves at {} is not to be found within {}; it is up to {} off its path: check [machine] stiffness and inertia</source>
        <translation>vorhergesagte Abweichung: was der Fräser bei {} lässt, ist innerhalb von {} nicht zu finden; er ist bis zu {} neben seiner Bahn: prüfen Sie Steifigkeit und Trägheit [machine]</translation>
    </message>
    <message>
        <source>{}: [machine] states all that a trace can tell: name with {} what is to be identified anew</source>
        <translation>{}: [machine] gibt alles an, was eine Aufzeichnung sagen kann: nennen Sie mit {}, was neu bestimmt werden soll</translation>
    </message>
    <message>
        <source>the model leaves at most {} before and {} after the correction{}</source>
        <translation>das Modell lässt vor der Korrektur höchstens {} und danach {}{}</translation>
    </message>
    <message>
        <source>{} needs {}: tool, material, machine and stock</source>
        <translation>{} braucht {}: Werkzeug, Werkstoff, Maschine und Rohteil</translation>
    </message>
    <message>
        <source>{}: [tool] diameter_mm {:g} is not the tool diameter of the program, {:g}</source>
        <translation>{}: [tool] diameter_mm {:g} ist nicht der Werkzeugdurchmesser des Programms, {:g}</translation>
    </message>
    <message>
        <source>the touches do not tell the axes apart: both are taken as equally stiff</source>
        <translation>die Antastungen unterscheiden die Achsen nicht: beide gelten als gleich steif</translation>
    </message>
    <message>
        <source>{} takes parts of one depth; for several depths use {}</source>
        <translation>{} nimmt Teile einer Tiefe; für mehrere Tiefen nehmen Sie {}</translation>
    </message>
    <message>
        <source>{} needs {}: the stock of the setup is no even allowance_mm</source>
        <translation>{} braucht {}: das Rohteil der Einrichtung ist kein gleichmäßiges allowance_mm</translation>
    </message>
    <message>
        <source>{} is no part of [stock] allowance_mm {:g}, which the first cut started from</source>
        <translation>{} ist kein Teil von [stock] allowance_mm {:g}, von dem der erste Schnitt ausging</translation>
    </message>
    <message>
        <source>nothing was measured: the size of the correction is the model's alone; touch the first part</source>
        <translation>nichts wurde gemessen: die Größe der Korrektur kommt allein vom Modell; tasten Sie das erste Teil an</translation>
    </message>
    <message>
        <source>transfer function of the axes at the first touch: MSx {:.4f}, MSy {:.4f}</source>
        <translation>Übertragungsfunktion der Achsen bei der ersten Antastung: MSx {:.4f}, MSy {:.4f}</translation>
    </message>
    <message>
        <source>at {} a point was touched that the simulated program does not cut</source>
        <translation>bei {} wurde ein Punkt angetastet, den das simulierte Programm nicht schneidet</translation>
    </message>
    <message>
        <source>the touches do not tell the rows of [machine] stiffness_along apart: all are off by one factor; touch at each of its places</source>
        <translation>die Antastungen unterscheiden die Zeilen von [machine] stiffness_along nicht: alle weichen um einen Faktor ab; tasten Sie an jeder ihrer Stellen an</translation>
    </message>
    <message>
        <source>, in {} rounds</source>
        <translation>, in {} Runden</translation>
    </message>
    <message>
        <source>[machine] position_gain_per_s {:g} is above 1000 (1/s)</source>
        <translation>[machine] position_gain_per_s {:g} liegt über 1000 (1/s)</translation>
    </message>
    <message>
        <source>[machine] {} {:g} is neither 0 nor at least 1 (ms)</source>
        <translation>[machine] {} {:g} ist weder 0 noch mindestens 1 (ms)</translation>
    </message>
    <message>
        <source>[machine] contour_time_offset_ms and contour_time_slope_ms_per_mm_min are both 0: contour control takes its time</source>
        <translation>[machine] contour_time_offset_ms und contour_time_slope_ms_per_mm_min sind beide 0: Bahnsteuerung braucht ihre Zeit</translation>
    </message>
    <message>
        <source>after {} {} are still predicted at {}, more than {}</source>
        <translation>nach {} sind noch {} bei {} vorhergesagt, mehr als {}</translation>
    </message>
    <message>
        <source>{}: the cutter cannot follow so quick a change; allow more</source>
        <translation>{}: der Fräser kann einer so schnellen Änderung nicht folgen; erlauben Sie mehr</translation>
    </message>
    <message>
        <source>1 round</source>
        <translation>1 Runde</translation>
    </message>
    <message>
        <source>{} rounds</source>
        <translation>{} Runden</translation>
    </message>
    <message>
        <source>{}, which the axes leave: lower the feed there (simulate {})</source>
        <translation>{}, was von den Achsen kommt: senken Sie dort den Vorschub (Simulation mit {})</translation>
    </message>
    <message>
        <source>{}: the unit of the dwells is not known, they are taken as seconds</source>
        <translation>{}: die Einheit der Verweilzeiten ist nicht bekannt, sie gelten als Sekunden</translation>
    </message>
    <message>
        <source>cutting coefficients of {} are not calibrated on this machine ({}): forces are good to a factor of two</source>
        <translation>die Schnittkraftkoeffizienten von {} sind nicht auf dieser Maschine kalibriert ({}): Kräfte stimmen bis auf den Faktor zwei</translation>
    </message>
    <message>
        <source>stiffness of {:g} and {:g} N/mm: {}</source>
        <translation>Steifigkeit {:g} und {:g} N/mm: {}</translation>
    </message>
    <message>
        <source>: is it {}?</source>
        <translation>: meinen Sie {}?</translation>
    </message>
    <message>
        <source>, known are {}</source>
        <translation>, bekannt sind {}</translation>
    </message>
    <message>
        <source>GPa: 600 for carbide, 210 for high-speed steel</source>
        <translation>GPa: 600 für Hartmetall, 210 für Schnellarbeitsstahl</translation>
    </message>
    <message>
        <source>N/mm: an end mill has 500 to 100000 (1 N/um = 1000 N/mm)</source>
        <translation>N/mm: ein Schaftfräser hat 500 bis 100000 (1 N/um = 1000 N/mm)</translation>
    </message>
    <message>
        <source>mm, not um</source>
        <translation>mm, nicht µm</translation>
    </message>
    <message>
        <source>N/mm2: 500 to 5000 for metals</source>
        <translation>N/mm²: 500 bis 5000 für Metalle</translation>
    </message>
    <message>
        <source>N/mm (1 N/um = 1000 N/mm)</source>
        <translation>N/mm (1 N/µm = 1000 N/mm)</translation>
    </message>
    <message>
        <source>mm/min: the feed difference that the control allows at a corner</source>
        <translation>mm/min: der Vorschubunterschied, den die Steuerung an einer Ecke erlaubt</translation>
    </message>
    <message>
        <source>1/s, not (m/min)/mm: Kv 1 is 16.67/s</source>
        <translation>1/s, nicht (m/min)/mm: Kv 1 ist 16,67/s</translation>
    </message>
    <message>
        <source>{} is none of {}</source>
        <translation>{} ist keines von {}</translation>
    </message>
    <message>
        <source>the material</source>
        <translation>dem Werkstoff</translation>
    </message>
    <message>
        <source>origin not stated</source>
        <translation>Herkunft nicht angegeben</translation>
    </message>
    <message>
        <source>{}: [machine] {} is missing: deflection needs the stiffness of both axes</source>
        <translation>{}: [machine] {} fehlt: die Verformung braucht die Steifigkeit beider Achsen</translation>
    </message>
    <message>
        <source>[stock] is missing: give allowance_mm, contour, program or solid = true</source>
        <translation>[stock] fehlt: geben Sie allowance_mm, contour, program oder solid = true an</translation>
    </message>
    <message>
        <source>[stock] {} and {} say the same twice: give one of them</source>
        <translation>[stock] {} und {} sagen dasselbe: geben Sie eines davon an</translation>
    </message>
    <message>
        <source>[stock] program_tool_diameter_mm goes with program, which is missing</source>
        <translation>[stock] program_tool_diameter_mm gehört zu program, das fehlt</translation>
    </message>
    <message>
        <source>[stock] end = "{}" goes with allowance_mm or contour, one is missing</source>
        <translation>[stock] end = "{}" gehört zu allowance_mm oder contour, eines davon fehlt</translation>
    </message>
    <message>
        <source>[stock] top_z_mm or axial_depth_mm is needed, one of them: it says how deep the tool cuts</source>
        <translation>[stock] top_z_mm oder axial_depth_mm wird gebraucht, eines davon: es sagt, wie tief das Werkzeug schneidet</translation>
    </message>
    <message>
        <source>[machine] contour_speed_change_mm_min is missing: contour_control needs the speed change allowed at a corner</source>
        <translation>[machine] contour_speed_change_mm_min fehlt: contour_control braucht die an einer Ecke erlaubte Geschwindigkeitsänderung</translation>
    </message>
    <message>
        <source>[tool] overhang_mm {:g} is more than 40 diameters: is its unit mm?</source>
        <translation>[tool] overhang_mm {:g} ist mehr als 40 Durchmesser: ist die Einheit mm?</translation>
    </message>
    <message>
        <source>[tool] overhang_mm {:g} is shorter than the cut of {}</source>
        <translation>[tool] overhang_mm {:g} ist kürzer als der Schnitt von {}</translation>
    </message>
    <message>
        <source>too large for a setup</source>
        <translation>zu groß für eine Einrichtung</translation>
    </message>
    <message>
        <source>not TOML: {}</source>
        <translation>kein TOML: {}</translation>
    </message>
    <message>
        <source>[{}] is unknown{}</source>
        <translation>[{}] ist unbekannt{}</translation>
    </message>
    <message>
        <source>[{}] is a table of keys</source>
        <translation>[{}] ist eine Tabelle von Schlüsseln</translation>
    </message>
    <message>
        <source>[material] {} is missing: ks_n_per_mm2 and mu go together</source>
        <translation>[material] {} fehlt: ks_n_per_mm2 und mu gehören zusammen</translation>
    </message>
    <message>
        <source>[material] {} {!r} is not a number from {:g} to {:g}</source>
        <translation>[material] {} {!r} ist keine Zahl von {:g} bis {:g}</translation>
    </message>
    <message>
        <source>[material] {} and ks_n_per_mm2 say the same twice: give one of them</source>
        <translation>[material] {} und ks_n_per_mm2 sagen dasselbe: geben Sie eines davon an</translation>
    </message>
    <message>
        <source>[{}] {} is unknown{}</source>
        <translation>[{}] {} ist unbekannt{}</translation>
    </message>
    <message>
        <source>[{}] {} is missing</source>
        <translation>[{}] {} fehlt</translation>
    </message>
    <message>
        <source>{}: {!r} is no row [mm, kx_n_per_mm, ky_n_per_mm]</source>
        <translation>{}: {!r} ist keine Zeile [mm, kx_n_per_mm, ky_n_per_mm]</translation>
    </message>
    <message>
        <source>{}: {!r}: stiffness is above 1 and at most 1e+07 N/mm</source>
        <translation>{}: {!r}: die Steifigkeit liegt über 1 und höchstens bei 1e+07 N/mm</translation>
    </message>
    <message>
        <source>[material] {} is missing: give ktc_n_per_mm2 and krc_n_per_mm2, or ks_n_per_mm2 and mu</source>
        <translation>[material] {} fehlt: geben Sie ktc_n_per_mm2 und krc_n_per_mm2 an, oder ks_n_per_mm2 und mu</translation>
    </message>
    <message>
        <source>{} is not a whole number{}</source>
        <translation>{} ist keine ganze Zahl{}</translation>
    </message>
    <message>
        <source>{} is not a number{}</source>
        <translation>{} ist keine Zahl{}</translation>
    </message>
    <message>
        <source>{} is not {}{}{}</source>
        <translation>{} ist nicht {}{}{}</translation>
    </message>
    <message>
        <source>[machine] {}: {} is 0 or more and ascends, {:g} does not</source>
        <translation>[machine] {}: {} ist 0 oder mehr und steigt an, {:g} nicht</translation>
    </message>
    <message>
        <source>{} is not true or false</source>
        <translation>{} ist weder wahr noch falsch (true, false)</translation>
    </message>
    <message>
        <source>{} is not the name of a file</source>
        <translation>{} ist kein Dateiname</translation>
    </message>
    <message>
        <source>{} is not a text</source>
        <translation>{} ist kein Text</translation>
    </message>
    <message>
        <source>{}: [machine] stiffness_along needs a nominal of one contour, which it goes along</source>
        <translation>{}: [machine] stiffness_along braucht ein Nennprofil mit einer Kontur, entlang der es gilt</translation>
    </message>
    <message>
        <source>{}: [machine] stiffness_along goes to {}, the contour is {} long</source>
        <translation>{}: [machine] stiffness_along reicht bis {}, die Kontur ist {} lang</translation>
    </message>
    <message>
        <source>NOT CORRECTED</source>
        <translation>NICHT KORRIGIERT</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>korrigiert</translation>
    </message>
    <message>
        <source>corrected by its own deviation</source>
        <translation>mit seiner eigenen Abweichung korrigiert</translation>
    </message>
    <message>
        <source>corrected by the smoothed deviation</source>
        <translation>mit der geglätteten Abweichung korrigiert</translation>
    </message>
    <message>
        <source>PENDING: the next run that uses the journal settles it</source>
        <translation>OFFEN: der nächste Lauf mit diesem Journal klärt es</translation>
    </message>
    <message>
        <source>{} is no table of a journal and stays untouched: name another file</source>
        <translation>{} ist keine Tabelle eines Journals und bleibt unberührt: nennen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>{} is a directory; name a file</source>
        <translation>{} ist ein Verzeichnis; nennen Sie eine Datei</translation>
    </message>
    <message>
        <source>{}: there is no directory {}: make it first</source>
        <translation>{}: es gibt kein Verzeichnis {}: legen Sie es erst an</translation>
    </message>
    <message>
        <source>{}: the journal cannot be written: no permission</source>
        <translation>{}: das Journal kann nicht geschrieben werden: keine Berechtigung</translation>
    </message>
    <message>
        <source>{}: there is no such journal</source>
        <translation>{}: dieses Journal gibt es nicht</translation>
    </message>
    <message>
        <source>an SQLite file of another program, not a journal of millcorr</source>
        <translation>eine SQLite-Datei eines anderen Programms, kein Journal von millcorr</translation>
    </message>
    <message>
        <source>written by a newer millcorr (journal version {}, this one knows {}): update millcorr</source>
        <translation>von einem neueren millcorr geschrieben (Journalversion {}, dieses kennt {}): aktualisieren Sie millcorr</translation>
    </message>
    <message>
        <source>the journal is damaged ({}): restore it from a copy</source>
        <translation>das Journal ist beschädigt ({}): stellen Sie es aus einer Kopie wieder her</translation>
    </message>
    <message>
        <source>{}: not what the journal {} announced; part {} was not recorded</source>
        <translation>{}: nicht, was das Journal {} angekündigt hat; Teil {} wurde nicht eingetragen</translation>
    </message>
    <message>
        <source>{}: the journal cannot be read or written ({})</source>
        <translation>{}: das Journal kann nicht gelesen oder geschrieben werden ({})</translation>
    </message>
    <message>
        <source>not a journal of millcorr, or damaged ({}): give the journal, or restore it from a copy</source>
        <translation>kein Journal von millcorr, oder beschädigt ({}): geben Sie das Journal an, oder stellen Sie es aus einer Kopie wieder her</translation>
    </message>
    <message>
        <source>{}: this measurement is part {} of {} already (as {} on {}, for {}); measure a new part</source>
        <translation>{}: diese Messung ist schon Teil {} von {} (als {} am {}, für {}); messen Sie ein neues Teil</translation>
    </message>
    <message>
        <source>{}: another run has held the journal for too long; try again when it is done</source>
        <translation>{}: ein anderer Lauf hält das Journal zu lange; versuchen Sie es wieder, wenn er fertig ist</translation>
    </message>
    <message>
        <source>the smoothed deviation of a series is damaged ({}): correct from the part again</source>
        <translation>die geglättete Abweichung einer Serie ist beschädigt ({}): korrigieren Sie noch einmal vom Teil aus</translation>
    </message>
    <message>
        <source>the smoothed deviation, {} at most, is beyond the limit of {}</source>
        <translation>die geglättete Abweichung, höchstens {}, liegt über der Grenze von {}</translation>
    </message>
    <message>
        <source>the smoothed deviation, {} at most, is within the limit of {}</source>
        <translation>die geglättete Abweichung, höchstens {}, liegt innerhalb der Grenze von {}</translation>
    </message>
    <message>
        <source>{}: write ewma:K, such as ewma:2, K being how many parts are smoothed over</source>
        <translation>{}: schreiben Sie ewma:K, etwa ewma:2; über K Teile wird geglättet</translation>
    </message>
    <message>
        <source>the part is {} off, more than {}: this cannot be a part of this program; nothing was recorded or written</source>
        <translation>das Teil weicht um {} ab, mehr als {}: das kann kein Teil dieses Programms sein; nichts wurde eingetragen oder geschrieben</translation>
    </message>
    <message>
        <source>the part is {} off, more than {}: look for the cause; if it is real and stays (a new tool), {} corrects it; nothing was recorded or written</source>
        <translation>das Teil weicht um {} ab, mehr als {}: suchen Sie die Ursache; ist sie echt und bleibt sie (ein neues Werkzeug), korrigiert {} sie; nichts wurde eingetragen oder geschrieben</translation>
    </message>
    <message>
        <source>the part itself is {} off, beyond the tolerance of {}: corrected by its own deviation</source>
        <translation>das Teil selbst weicht um {} ab, über der Toleranz von {}: mit seiner eigenen Abweichung korrigiert</translation>
    </message>
    <message>
        <source>first correction: the deviation, {} at most, is beyond the limit of {}</source>
        <translation>erste Korrektur: die Abweichung, höchstens {}, liegt über der Grenze von {}</translation>
    </message>
    <message>
        <source>the deviation, {} at most, is within the limit of {}</source>
        <translation>die Abweichung, höchstens {}, liegt innerhalb der Grenze von {}</translation>
    </message>
    <message>
        <source>one correction would move the contour</source>
        <translation>eine Korrektur würde die Kontur verschieben</translation>
    </message>
    <message>
        <source>look for what jumped</source>
        <translation>suchen Sie, was gesprungen ist</translation>
    </message>
    <message>
        <source>all corrections together would move the contour</source>
        <translation>alle Korrekturen zusammen würden die Kontur verschieben</translation>
    </message>
    <message>
        <source>change the tool</source>
        <translation>wechseln Sie das Werkzeug</translation>
    </message>
    <message>
        <source>{}: K must be 1 or more</source>
        <translation>{}: K muss mindestens 1 sein</translation>
    </message>
    <message>
        <source>{}: must not be negative</source>
        <translation>{}: darf nicht negativ sein</translation>
    </message>
    <message>
        <source>{} needs {}: the program stays as it is within it</source>
        <translation>{} braucht {}: innerhalb davon bleibt das Programm, wie es ist</translation>
    </message>
    <message>
        <source>{} must not be above {}</source>
        <translation>{} darf nicht über {} liegen</translation>
    </message>
    <message>
        <source>{} by {}, more than {}: {}, or raise the limit; nothing was recorded or written</source>
        <translation>{} um {}, mehr als {}: {}, oder heben Sie die Grenze an; nichts wurde eingetragen oder geschrieben</translation>
    </message>
    <message>
        <source>{}: must be above 0</source>
        <translation>{}: muss über 0 liegen</translation>
    </message>
    <message>
        <source>{} must be below {}: dead band &lt; limit &lt; tolerance &lt; alarm &lt; abort</source>
        <translation>{} muss unter {} liegen: Totband &lt; Grenze &lt; Toleranz &lt; Alarm &lt; Abbruch</translation>
    </message>
    <message>
        <source>{} needs {}, how far the tool may pass a corner</source>
        <translation>{} braucht {}, den Abstand, in dem das Werkzeug eine Ecke verfehlen darf</translation>
    </message>
    <message>
        <source>{}: {} needs [machine] acceleration_time_x_ms, acceleration_time_y_ms or position_gain_per_s: without inertia no corner is rounded off</source>
        <translation>{}: {} braucht [machine] acceleration_time_x_ms, acceleration_time_y_ms oder position_gain_per_s: ohne Trägheit wird keine Ecke verrundet</translation>
    </message>
    <message>
        <source>{}: the moved path no longer makes the same walls: nothing is written</source>
        <translation>{}: die verschobene Bahn macht nicht mehr dieselben Wände: nichts wird geschrieben</translation>
    </message>
    <message>
        <source>{}: the tilted program does not read back as it was meant: nothing is written</source>
        <translation>{}: das geneigte Programm liest sich nicht so zurück, wie es gemeint war: nichts wird geschrieben</translation>
    </message>
    <message>
        <source>the last {} parts share a form of up to {} that none of them shows alone (they scatter by {}): it stays in the next part; {} {} takes it out</source>
        <translation>die letzten {} Teile haben eine Form von bis zu {} gemeinsam, die keines davon allein zeigt (sie streuen um {}): sie bleibt im nächsten Teil; {} {} nimmt sie heraus</translation>
    </message>
    <message>
        <source>{} needs {}: what earlier parts have shown is kept there</source>
        <translation>{} braucht {}: dort steht, was frühere Teile gezeigt haben</translation>
    </message>
    <message>
        <source>{} keeps measured parts: nothing was measured</source>
        <translation>{} hält gemessene Teile fest: nichts wurde gemessen</translation>
    </message>
    <message>
        <source>{}: {} goes on from {}; since {} it was corrected by part {} on {}, and correcting again from a part of the earlier program would count its error twice: measure a part cut with {}</source>
        <translation>{}: {} geht von {} aus weiter; {} wurde inzwischen mit Teil {} am {} korrigiert, und noch einmal von einem Teil des früheren Programms aus zu korrigieren würde dessen Fehler doppelt zählen: messen Sie ein Teil, das mit {} gefräst wurde</translation>
    </message>
    <message>
        <source>{}: it carries a correction (measurement {}) that {} does not know; begin a new journal with {}</source>
        <translation>{}: es trägt eine Korrektur (Messung {}), die {} nicht kennt; beginnen Sie ein neues Journal mit {}</translation>
    </message>
    <message>
        <source>{}: the nominal has other contours or lengths than in {}: give the same {} and measure the same contours on every part, or begin a new journal with {}</source>
        <translation>{}: das Nennprofil hat andere Konturen oder Längen als in {}: geben Sie dasselbe {} an und messen Sie an jedem Teil dieselben Konturen, oder beginnen Sie ein neues Journal mit {}</translation>
    </message>
    <message>
        <source>{} goes with {} or transfer, not with {}: it smooths what whole contours have shown over the parts, not what a model expects</source>
        <translation>{} gehört zu {} oder Übertragung, nicht zu {}: es glättet, was ganze Konturen über die Teile gezeigt haben, nicht was ein Modell erwartet</translation>
    </message>
    <message>
        <source>{} watches a series of finished parts: it does not go with {}</source>
        <translation>{} überwacht eine Serie fertiger Teile: es passt nicht zu {}</translation>
    </message>
    <message>
        <source>{} smooths over parts that are cut alike: give one {} and no other {}; for a new depth correct once without {}</source>
        <translation>{} glättet über Teile, die gleich gefräst werden: geben Sie ein {} und kein anderes {} an; für eine neue Tiefe korrigieren Sie einmal ohne {}</translation>
    </message>
    <message>
        <source>corrected as the settings say</source>
        <translation>korrigiert, wie die Einstellungen sagen</translation>
    </message>
    <message>
        <source>nothing is to be corrected</source>
        <translation>nichts ist zu korrigieren</translation>
    </message>
    <message>
        <source>NOT CORRECTED: {}; the output is the very bytes of {}</source>
        <translation>NICHT KORRIGIERT: {}; die Ausgabe ist Byte für Byte {}</translation>
    </message>
    <message>
        <source>{} belongs to {}</source>
        <translation>{} gehört zu {}</translation>
    </message>
    <message>
        <source>corrected: {}</source>
        <translation>korrigiert: {}</translation>
    </message>
    <message>
        <source>{} needs {} at two heights at least: the tool leans by the wall's slope</source>
        <translation>{} braucht {} mit mindestens zwei Höhen: das Werkzeug neigt sich um die Steigung der Wand</translation>
    </message>
    <message>
        <source>{} needs {}: the contour is moved by the wall's mean error over them</source>
        <translation>{} braucht {}: die Kontur wird um den mittleren Fehler der Wand darüber verschoben</translation>
    </message>
    <message>
        <source>tilt: {}</source>
        <translation>Neigung: {}</translation>
    </message>
    <message>
        <source>{} belongs to {}, the log that tells</source>
        <translation>{} gehört zu {}, der Aufzeichnung, die es sagt</translation>
    </message>
    <message>
        <source>{} belongs to {}, the program that keeps it</source>
        <translation>{} gehört zu {}, dem Programm, das ihn einhält</translation>
    </message>
    <message>
        <source>{}: the allowance must be above 0</source>
        <translation>{}: das Aufmaß muss über 0 liegen</translation>
    </message>
    <message>
        <source>{}: the first cut takes a share between 0 and 1</source>
        <translation>{}: der erste Schnitt nimmt einen Anteil zwischen 0 und 1</translation>
    </message>
    <message>
        <source>{}:{}: the program was corrected before; split the first, uncorrected one</source>
        <translation>{}:{}: das Programm wurde schon korrigiert; teilen Sie das erste, unkorrigierte</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittelwerts</translation>
    </message>
    <message>
        <source>place X</source>
        <translation>Lage in X</translation>
    </message>
    <message>
        <source>place Y</source>
        <translation>Lage in Y</translation>
    </message>
    <message>
        <source>form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>tool wear or warming</source>
        <translation>Werkzeugverschleiß oder Erwärmung</translation>
    </message>
    <message>
        <source>warming of the machine or of the fixture</source>
        <translation>Erwärmung der Maschine oder der Spannvorrichtung</translation>
    </message>
    <message>
        <source>wear or warming that is not the same all along the contour</source>
        <translation>Verschleiß oder Erwärmung, die nicht überall an der Kontur gleich ist</translation>
    </message>
    <message>
        <source>another tool, another stock, or a clamping that bends the part</source>
        <translation>ein anderes Werkzeug, ein anderes Rohteil oder eine Spannung, die das Teil biegt</translation>
    </message>
    <message>
        <source>a new tool, another offset or another batch of material</source>
        <translation>ein neues Werkzeug, eine andere Korrektur im Werkzeugspeicher oder eine andere Materialcharge</translation>
    </message>
    <message>
        <source>a chip at the stop, another clamping or another datum</source>
        <translation>ein Span am Anschlag, eine andere Spannung oder ein anderer Bezug</translation>
    </message>
    <message>
        <source>jump of the {} by {} before part {} (p {:.1g}): {}</source>
        <translation>Sprung ({}) um {} vor Teil {} (p {:.1g}): {}</translation>
    </message>
    <message>
        <source>drift of the {} by {} a part from part {} to {} (+- {}, p {:.1g}): {}</source>
        <translation>Drift ({}) um {} je Teil von Teil {} bis {} (± {}, p {:.1g}): {}</translation>
    </message>
    <message>
        <source>{}; one part shows it so far, measure another</source>
        <translation>{}; bisher zeigt es ein Teil, messen Sie ein weiteres</translation>
    </message>
    <message>
        <source>No remedy: a slope needs two heights at least, give {} again.</source>
        <translation>Keine Abhilfe: eine Steigung braucht mindestens zwei Höhen, geben Sie {} noch einmal an.</translation>
    </message>
    <message>
        <source>{}: heights count from the tool's tip upwards, in mm: give 0 or more</source>
        <translation>{}: Höhen zählen in mm von der Werkzeugspitze aufwärts: geben Sie 0 oder mehr an</translation>
    </message>
    <message>
        <source>{}: {} cuts its wall up to {} above the tool's tip: give 0 to {:g}, or correct [stock] in {}</source>
        <translation>{}: {} schneidet seine Wand bis {} über der Werkzeugspitze: geben Sie 0 bis {:g} an, oder berichtigen Sie [stock] in {}</translation>
    </message>
    <message>
        <source>No remedy: {}</source>
        <translation>Keine Abhilfe: {}</translation>
    </message>
    <message>
        <source>the setup</source>
        <translation>der Einrichtung</translation>
    </message>
    <message>
        <source>the work frame; the file does not say</source>
        <translation>das Werkstücksystem; die Datei sagt nichts</translation>
    </message>
    <message>
        <source>what G330 leads back to</source>
        <translation>das, wohin G330 zurückführt</translation>
    </message>
    <message>
        <source>the document's common frame</source>
        <translation>das gemeinsame System des Dokuments</translation>
    </message>
    <message>
        <source>the work frame in force, as LinuxCNC logs it</source>
        <translation>das geltende Werkstücksystem, wie LinuxCNC es protokolliert</translation>
    </message>
    <message>
        <source>the machine's, brought to the work frame by the offset in the log</source>
        <translation>das der Maschine, mit der Nullpunktverschiebung des Protokolls ins Werkstücksystem gebracht</translation>
    </message>
    <message>
        <source>{} is no radius in mm</source>
        <translation>{} ist kein Radius in mm</translation>
    </message>
    <message>
        <source>{} belongs to {} or axis: contact points lie on the part already</source>
        <translation>{} gehört zu {} oder zur Achse: Berührpunkte liegen schon auf dem Teil</translation>
    </message>
    <message>
        <source>{} is no place</source>
        <translation>{} ist kein Ort</translation>
    </message>
    <message>
        <source>{} is no angle</source>
        <translation>{} ist kein Winkel</translation>
    </message>
    <message>
        <source>{} is for text that no format covers: leave {} out</source>
        <translation>{} ist für Text, den kein Format abdeckt: lassen Sie {} weg</translation>
    </message>
    <message>
        <source>{}: {} holds one measured part</source>
        <translation>{}: {} enthält ein gemessenes Teil</translation>
    </message>
    <message>
        <source>{} contradicts {}, whose points are centres of the probe ball</source>
        <translation>{} widerspricht {}, deren Punkte Mittelpunkte der Tasterkugel sind</translation>
    </message>
    <message>
        <source>not a file</source>
        <translation>keine Datei</translation>
    </message>
    <message>
        <source>measured part {}</source>
        <translation>gemessenes Teil {}</translation>
    </message>
    <message>
        <source>{} features with X and Y and no size are taken for points</source>
        <translation>{} Merkmale mit X und Y und ohne Größe gelten als Punkte</translation>
    </message>
    <message>
        <source>no single column {}: not Calypso's table of characteristics or features; give the file that ends in _chr.txt or _fet.txt, or say by {} what the columns are and which rows are points</source>
        <translation>keine eindeutige Spalte {}: keine Merkmals- oder Elementtabelle von Calypso; geben Sie die Datei an, die auf _chr.txt oder _fet.txt endet, oder sagen Sie mit {}, was die Spalten sind und welche Zeilen Punkte</translation>
    </message>
    <message>
        <source>part {}, {}</source>
        <translation>Teil {}, {}</translation>
    </message>
    <message>
        <source>{}: the table does not name their kind</source>
        <translation>{}: die Tabelle nennt ihre Art nicht</translation>
    </message>
    <message>
        <source>{} of axis {} is no coordinate</source>
        <translation>{} der Achse {} ist keine Koordinate</translation>
    </message>
    <message>
        <source>no rows below the header</source>
        <translation>keine Zeilen unter der Kopfzeile</translation>
    </message>
    <message>
        <source>no row of the kind Point or SpacePoint, only {}</source>
        <translation>keine Zeile der Art Point oder SpacePoint, nur {}</translation>
    </message>
    <message>
        <source>{} points were not measured</source>
        <translation>{} Punkte wurden nicht gemessen</translation>
    </message>
    <message>
        <source>{} other features left out: {}</source>
        <translation>{} andere Merkmale weggelassen: {}</translation>
    </message>
    <message>
        <source>{} of {} points have no normal: normals are not used</source>
        <translation>{} von {} Punkten haben keine Normale: Normalen werden nicht verwendet</translation>
    </message>
    <message>
        <source>none of {} features has xValue and yValue and no other characteristic</source>
        <translation>keines von {} Merkmalen hat xValue und yValue und keine andere Kenngröße</translation>
    </message>
    <message>
        <source>{} has no zValue, others have</source>
        <translation>{} hat kein zValue, andere schon</translation>
    </message>
    <message>
        <source>{} other features left out{}</source>
        <translation>{} andere Merkmale weggelassen{}</translation>
    </message>
    <message>
        <source>{} columns: the row is incomplete; {}</source>
        <translation>{} Spalten: die Zeile ist unvollständig; {}</translation>
    </message>
    <message>
        <source>feature {} is there twice, first in line {}</source>
        <translation>Merkmal {} kommt zweimal vor, zuerst in Zeile {}</translation>
    </message>
    <message>
        <source>{} of {} is there twice, first from line {}</source>
        <translation>{} von {} kommt zweimal vor, zuerst ab Zeile {}</translation>
    </message>
    <message>
        <source>coordinates in different units: export them in one</source>
        <translation>Koordinaten in verschiedenen Einheiten: geben Sie sie in einer aus</translation>
    </message>
    <message>
        <source>unit {}: only mm and inch are read</source>
        <translation>Einheit {}: nur mm und Zoll werden gelesen</translation>
    </message>
    <message>
        <source>a header</source>
        <translation>eine Kopfzeile</translation>
    </message>
    <message>
        <source>{}: deviation is not actual less nominal, export the table again</source>
        <translation>{}: die Abweichung ist nicht Ist minus Soll, geben Sie die Tabelle neu aus</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>ein PDF-Dokument</translation>
    </message>
    <message>
        <source>export the points as CSV</source>
        <translation>geben Sie die Punkte als CSV aus</translation>
    </message>
    <message>
        <source>a ZIP container (a workbook, a FreeCAD document?)</source>
        <translation>ein ZIP-Archiv (eine Arbeitsmappe, ein FreeCAD-Dokument?)</translation>
    </message>
    <message>
        <source>save the points as CSV</source>
        <translation>speichern Sie die Punkte als CSV</translation>
    </message>
    <message>
        <source>an Excel workbook</source>
        <translation>eine Excel-Arbeitsmappe</translation>
    </message>
    <message>
        <source>compressed (gzip)</source>
        <translation>komprimiert (gzip)</translation>
    </message>
    <message>
        <source>unpack it first</source>
        <translation>entpacken Sie sie erst</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>ein PNG-Bild</translation>
    </message>
    <message>
        <source>give the measured points</source>
        <translation>geben Sie die Messpunkte an</translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation>ein JPEG-Bild</translation>
    </message>
    <message>
        <source>a rich text document</source>
        <translation>ein RTF-Dokument</translation>
    </message>
    <message>
        <source>save the points as plain text</source>
        <translation>speichern Sie die Punkte als einfachen Text</translation>
    </message>
    <message>
        <source>a STEP model</source>
        <translation>ein STEP-Modell</translation>
    </message>
    <message>
        <source>give the measured points, not the model</source>
        <translation>geben Sie die Messpunkte an, nicht das Modell</translation>
    </message>
    <message>
        <source>binary data (control character {}): not a text file</source>
        <translation>Binärdaten (Steuerzeichen {}): keine Textdatei</translation>
    </message>
    <message>
        <source>the file is XML or HTML: export the points as text with a header x,y,z</source>
        <translation>die Datei ist XML oder HTML: geben Sie die Punkte als Text mit der Kopfzeile x,y,z aus</translation>
    </message>
    <message>
        <source>the file holds nothing but blanks</source>
        <translation>die Datei enthält nur Leerzeichen</translation>
    </message>
    <message>
        <source>the file is {}: {}</source>
        <translation>die Datei ist {}: {}</translation>
    </message>
    <message>
        <source>binary or truncated</source>
        <translation>binär oder abgeschnitten</translation>
    </message>
    <message>
        <source>the file is {}: no text in {}</source>
        <translation>die Datei ist {}: kein Text in {}</translation>
    </message>
    <message>
        <source>the file ends in the middle of a statement: it was cut off</source>
        <translation>die Datei endet mitten in einer Anweisung: sie wurde abgeschnitten</translation>
    </message>
    <message>
        <source>a statement of more than {} characters</source>
        <translation>eine Anweisung mit mehr als {} Zeichen</translation>
    </message>
    <message>
        <source>UNITS/{}: only MM and INCH are read</source>
        <translation>UNITS/{}: nur MM und INCH werden gelesen</translation>
    </message>
    <message>
        <source>the unit changes: export the points in one</source>
        <translation>die Einheit wechselt: geben Sie die Punkte in einer aus</translation>
    </message>
    <message>
        <source>PTDATA without a curve or surface above it</source>
        <translation>PTDATA ohne Kurve oder Fläche darüber</translation>
    </message>
    <message>
        <source>PTDATA of {}</source>
        <translation>PTDATA von {}</translation>
    </message>
    <message>
        <source>{}: neither CART nor POL</source>
        <translation>{}: weder CART noch POL</translation>
    </message>
    <message>
        <source>{}: {} numbers where 3 or 6 were expected</source>
        <translation>{}: {} Zahlen, wo 3 oder 6 erwartet wurden</translation>
    </message>
    <message>
        <source>{} is no number</source>
        <translation>{} ist keine Zahl</translation>
    </message>
    <message>
        <source>{} is no length that a machine can travel</source>
        <translation>{} ist keine Länge, die eine Maschine fahren kann</translation>
    </message>
    <message>
        <source>, only {}</source>
        <translation>, nur {}</translation>
    </message>
    <message>
        <source>no measured points FA(...)=FEAT/POINT in the file{}</source>
        <translation>keine Messpunkte FA(...)=FEAT/POINT in der Datei{}</translation>
    </message>
    <message>
        <source>no ENDFIL: points may be missing at the end of the file</source>
        <translation>kein ENDFIL: am Ende der Datei können Punkte fehlen</translation>
    </message>
    <message>
        <source>{} repetitions of points left out: they are equal</source>
        <translation>{} Wiederholungen von Punkten weggelassen: sie sind gleich</translation>
    </message>
    <message>
        <source>measured features left out: {}</source>
        <translation>gemessene Merkmale weggelassen: {}</translation>
    </message>
    <message>
        <source>{} nominal points were not measured</source>
        <translation>{} Sollpunkte wurden nicht gemessen</translation>
    </message>
    <message>
        <source>{} has no UNITS statement</source>
        <translation>{} hat keine Anweisung UNITS</translation>
    </message>
    <message>
        <source>{} is no whole statement: export the file again</source>
        <translation>{} ist keine ganze Anweisung: geben Sie die Datei neu aus</translation>
    </message>
    <message>
        <source>FA({}) is there twice: export every curve once</source>
        <translation>FA({}) kommt zweimal vor: geben Sie jede Kurve einmal aus</translation>
    </message>
    <message>
        <source>FA({}) is a point and a curve</source>
        <translation>FA({}) ist ein Punkt und eine Kurve</translation>
    </message>
    <message>
        <source>FA({}) lies elsewhere than in line {}: export every point once</source>
        <translation>FA({}) liegt anderswo als in Zeile {}: geben Sie jeden Punkt einmal aus</translation>
    </message>
    <message>
        <source>work plane {} is not known</source>
        <translation>Arbeitsebene {} ist nicht bekannt</translation>
    </message>
    <message>
        <source>ball compensation changes between the points: export them apart</source>
        <translation>die Kugelkorrektur wechselt zwischen den Punkten: geben Sie sie getrennt aus</translation>
    </message>
    <message>
        <source>no points in the file</source>
        <translation>keine Punkte in der Datei</translation>
    </message>
    <message>
        <source>Z stands in some lines and not in others</source>
        <translation>Z steht in manchen Zeilen und in anderen nicht</translation>
    </message>
    <message>
        <source>point N{:g} is there twice, first in line {}: keep one of them, or give every point a number of its own</source>
        <translation>Punkt N{:g} kommt zweimal vor, zuerst in Zeile {}: behalten Sie einen davon, oder geben Sie jedem Punkt eine eigene Nummer</translation>
    </message>
    <message>
        <source>{} is no word of a printed point</source>
        <translation>{} ist kein Wort eines ausgedruckten Punkts</translation>
    </message>
    <message>
        <source>the letter {} is there twice: two lines ran together</source>
        <translation>der Buchstabe {} kommt zweimal vor: zwei Zeilen sind ineinandergelaufen</translation>
    </message>
    <message>
        <source>{}{} is no coordinate</source>
        <translation>{}{} ist keine Koordinate</translation>
    </message>
    <message>
        <source>a line of {} characters: no print-out, or damaged</source>
        <translation>eine Zeile von {} Zeichen: kein Ausdruck, oder beschädigt</translation>
    </message>
    <message>
        <source>{} is missing: the line is incomplete</source>
        <translation>{} fehlt: die Zeile ist unvollständig</translation>
    </message>
    <message>
        <source>{}: decimal points and decimal commas in one file; a spreadsheet may have spoilt it, export again with decimal points</source>
        <translation>{}: Dezimalpunkte und Dezimalkommas in einer Datei; eine Tabellenkalkulation kann sie verdorben haben, geben Sie sie mit Dezimalpunkten neu aus</translation>
    </message>
    <message>
        <source>a coordinate is missing: delete the row or measure the point again</source>
        <translation>eine Koordinate fehlt: löschen Sie die Zeile, oder messen Sie den Punkt noch einmal</translation>
    </message>
    <message>
        <source>{} is no measured value: delete the row or measure the point again</source>
        <translation>{} ist kein Messwert: löschen Sie die Zeile, oder messen Sie den Punkt noch einmal</translation>
    </message>
    <message>
        <source>{} is a date: a spreadsheet has spoilt the number, export again without it</source>
        <translation>{} ist ein Datum: eine Tabellenkalkulation hat die Zahl verdorben, geben Sie sie ohne diese neu aus</translation>
    </message>
    <message>
        <source>{}: thousands separator or decimal comma? Export with plain decimal points</source>
        <translation>{}: Tausendertrennzeichen oder Dezimalkomma? Geben Sie es mit einfachen Dezimalpunkten aus</translation>
    </message>
    <message>
        <source>three decimals, as GRBL prints mm</source>
        <translation>drei Nachkommastellen, wie GRBL mm ausgibt</translation>
    </message>
    <message>
        <source>places farther out than such machines go in inches</source>
        <translation>Orte weiter draußen, als solche Maschinen in Zoll fahren</translation>
    </message>
    <message>
        <source>machine frame, work offset by {}</source>
        <translation>Maschinensystem, Nullpunktverschiebung: {}</translation>
    </message>
    <message>
        <source>the touch failed, the ball met nothing: delete the line or measure the point again</source>
        <translation>die Antastung ist misslungen, die Kugel traf nichts: löschen Sie die Zeile, oder messen Sie den Punkt noch einmal</translation>
    </message>
    <message>
        <source>no probe report [PRB:x,y,z:1] in the log</source>
        <translation>keine Tastermeldung [PRB:x,y,z:1] im Protokoll</translation>
    </message>
    <message>
        <source>{} does not hold $13 and gives four decimals, as GRBL prints inches, and some builds of it mm</source>
        <translation>{} enthält kein $13 und gibt vier Nachkommastellen, wie GRBL Zoll ausgibt und manche seiner Fassungen mm</translation>
    </message>
    <message>
        <source>WCO of the log</source>
        <translation>WCO des Protokolls</translation>
    </message>
    <message>
        <source>{} contradicts {}, which holds {}: leave it out</source>
        <translation>{} widerspricht {}, mit {}: lassen Sie es weg</translation>
    </message>
    <message>
        <source>{} is damaged: log the touches again</source>
        <translation>{} ist beschädigt: protokollieren Sie die Antastungen noch einmal</translation>
    </message>
    <message>
        <source>{} of the log</source>
        <translation>{} des Protokolls</translation>
    </message>
    <message>
        <source>the $# report in the log does not hold the active {}</source>
        <translation>die Meldung $# des Protokolls enthält das aktive {} nicht</translation>
    </message>
    <message>
        <source>{} is in the machine frame and does not hold the work offset</source>
        <translation>{} steht im Maschinensystem und enthält die Nullpunktverschiebung nicht</translation>
    </message>
    <message>
        <source>machine frame, work offset as given</source>
        <translation>Maschinensystem, Nullpunktverschiebung wie angegeben</translation>
    </message>
    <message>
        <source>a height map, touched along Z: it shows the height of a surface and nothing of a contour</source>
        <translation>eine Höhenkarte, entlang Z angetastet: sie zeigt die Höhe einer Fläche und nichts von einer Kontur</translation>
    </message>
    <message>
        <source>no height in the map: it was not probed yet</source>
        <translation>keine Höhe in der Karte: sie wurde noch nicht angetastet</translation>
    </message>
    <message>
        <source>{} of {} places were not touched</source>
        <translation>{} von {} Orten wurden nicht angetastet</translation>
    </message>
    <message>
        <source>{} is no coordinate</source>
        <translation>{} ist keine Koordinate</translation>
    </message>
    <message>
        <source>{:g} by {:g} places are no grid</source>
        <translation>{:g} mal {:g} Orte sind kein Gitter</translation>
    </message>
    <message>
        <source>a height map begins with three lines: x and y from, to and how many, and z</source>
        <translation>eine Höhenkarte beginnt mit drei Zeilen: x und y von, bis und wie viele, und z</translation>
    </message>
    <message>
        <source>more than the {} places of the grid</source>
        <translation>mehr als die {} Orte des Gitters</translation>
    </message>
    <message>
        <source>X{:g} Y{:g} where the grid has X{:g} Y{:g}: lines are missing</source>
        <translation>X{:g} Y{:g}, wo das Gitter X{:g} Y{:g} hat: Zeilen fehlen</translation>
    </message>
    <message>
        <source>{} numbers where a height map has three in a line</source>
        <translation>{} Zahlen, wo eine Höhenkarte drei in einer Zeile hat</translation>
    </message>
    <message>
        <source>point {:g}, {:g} is not on the grid</source>
        <translation>Punkt {:g}, {:g} ist nicht auf dem Gitter</translation>
    </message>
    <message>
        <source>point {}, {} is there twice</source>
        <translation>Punkt {}, {} kommt zweimal vor</translation>
    </message>
    <message>
        <source>a number is too large, or not nine in a row</source>
        <translation>eine Zahl ist zu groß, oder es sind nicht neun in einer Zeile</translation>
    </message>
    <message>
        <source>axis {} moved between the touches: probe with X, Y and Z only</source>
        <translation>Achse {} hat sich zwischen den Antastungen bewegt: tasten Sie nur mit X, Y und Z an</translation>
    </message>
    <message>
        <source>other axes stood at {}</source>
        <translation>andere Achsen standen auf {}</translation>
    </message>
    <message>
        <source>{} numbers where X Y Z A B C U V W make nine: the row is damaged or cut off</source>
        <translation>{} Zahlen, wo X Y Z A B C U V W neun sind: die Zeile ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source> (is it {}?)</source>
        <translation> (ist es {}?)</translation>
    </message>
    <message>
        <source>the mapping</source>
        <translation>die Zuordnung</translation>
    </message>
    <message>
        <source>line {} does not name all columns of {}; lacking: {}</source>
        <translation>Zeile {} nennt nicht alle Spalten von {}; es fehlt: {}</translation>
    </message>
    <message>
        <source>no line names all columns of {}; lacking: {}</source>
        <translation>keine Zeile nennt alle Spalten von {}; es fehlt: {}</translation>
    </message>
    <message>
        <source>direction of travel</source>
        <translation>Antastrichtung</translation>
    </message>
    <message>
        <source>the file ends before line {}, where the mapping has the header</source>
        <translation>die Datei endet vor Zeile {}, in der nach der Zuordnung die Kopfzeile steht</translation>
    </message>
    <message>
        <source>{} has a decimal point: the mapping says decimal = {!r}</source>
        <translation>{} hat einen Dezimalpunkt: die Zuordnung sagt decimal = {!r}</translation>
    </message>
    <message>
        <source>no points below the header</source>
        <translation>keine Punkte unter der Kopfzeile</translation>
    </message>
    <message>
        <source>the mapping {}</source>
        <translation>die Zuordnung {}</translation>
    </message>
    <message>
        <source>columns by {}{}</source>
        <translation>Spalten nach {}{}</translation>
    </message>
    <message>
        <source>no text in {}, which the mapping says</source>
        <translation>kein Text in {}, wie die Zuordnung sagt</translation>
    </message>
    <message>
        <source>the row is incomplete, or the file was cut off</source>
        <translation>die Zeile ist unvollständig, oder die Datei wurde abgeschnitten</translation>
    </message>
    <message>
        <source>one too many</source>
        <translation>eine zu viel</translation>
    </message>
    <message>
        <source>{} columns where {} were expected: {}; {}</source>
        <translation>{} Spalten, wo {} erwartet wurden: {}; {}</translation>
    </message>
    <message>
        <source>{} columns, but the mapping takes column {}: is the separator {}?</source>
        <translation>{} Spalten, aber die Zuordnung nimmt Spalte {}: ist das Trennzeichen {}?</translation>
    </message>
    <message>
        <source>{} is no direction of travel: X+, X-, Y+, Y-, Z+ or Z-</source>
        <translation>{} ist keine Antastrichtung: X+, X-, Y+, Y-, Z+ oder Z-</translation>
    </message>
    <message>
        <source>{} is too large</source>
        <translation>{} ist zu groß</translation>
    </message>
    <message>
        <source>{} has a decimal comma: the mapping says decimal = {!r}</source>
        <translation>{} hat ein Dezimalkomma: die Zuordnung sagt decimal = {!r}</translation>
    </message>
    <message>
        <source>; there are {}</source>
        <translation>; es gibt {}</translation>
    </message>
    <message>
        <source>no row holds {}, which the mapping asks for{}</source>
        <translation>keine Zeile enthält {}, wie die Zuordnung verlangt{}</translation>
    </message>
    <message>
        <source>a line of {} characters is no row of numbers</source>
        <translation>eine Zeile von {} Zeichen ist keine Zeile von Zahlen</translation>
    </message>
    <message>
        <source>a mapping</source>
        <translation>einer Zuordnung</translation>
    </message>
    <message>
        <source>two columns are named {}: give their numbers in the mapping</source>
        <translation>zwei Spalten heißen {}: geben Sie in der Zuordnung ihre Nummern an</translation>
    </message>
    <message>
        <source>converted from a unit of {}</source>
        <translation>umgerechnet aus einer Einheit von {}</translation>
    </message>
    <message>
        <source>comma, semicolon, tab, blank, or one character that is no part of a number</source>
        <translation>comma, semicolon, tab, blank oder ein Zeichen, das nicht zu einer Zahl gehört</translation>
    </message>
    <message>
        <source>point or comma</source>
        <translation>point oder comma</translation>
    </message>
    <message>
        <source>the number of a line, from 1</source>
        <translation>die Nummer einer Zeile, ab 1</translation>
    </message>
    <message>
        <source>a number of lines, from 0</source>
        <translation>eine Zahl von Zeilen, ab 0</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a list of texts</source>
        <translation>eine Liste von Texten</translation>
    </message>
    <message>
        <source>the name of an encoding of text</source>
        <translation>der Name einer Textkodierung</translation>
    </message>
    <message>
        <source>mm or inch</source>
        <translation>mm oder inch</translation>
    </message>
    <message>
        <source>the millimetres in the unit of the file, such as 0.001</source>
        <translation>die Millimeter in der Einheit der Datei, etwa 0.001</translation>
    </message>
    <message>
        <source>one of {}</source>
        <translation>eines von {}</translation>
    </message>
    <message>
        <source>contact or centre, or axis</source>
        <translation>contact oder centre oder axis</translation>
    </message>
    <message>
        <source>the radius of the probe ball in mm, up to {:g}</source>
        <translation>der Radius der Tasterkugel in mm, bis {:g}</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>eine Tabelle</translation>
    </message>
    <message>
        <source>mapping</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <source>[columns] is missing: it says at least which columns are x and y</source>
        <translation>[columns] fehlt: es sagt zumindest, welche Spalten x und y sind</translation>
    </message>
    <message>
        <source>{} is {}, not {}</source>
        <translation>{} ist {}, nicht {}</translation>
    </message>
    <message>
        <source>columns: two are the same column of the file</source>
        <translation>columns: zwei sind dieselbe Spalte der Datei</translation>
    </message>
    <message>
        <source>columns: {} and nominal_{} go together</source>
        <translation>columns: {} und nominal_{} gehören zusammen</translation>
    </message>
    <message>
        <source>units and factor say the same twice</source>
        <translation>units und factor sagen dasselbe zweimal</translation>
    </message>
    <message>
        <source>columns: directions of travel are for points = 'axis'</source>
        <translation>columns: Antastrichtungen gehören zu points = 'axis'</translation>
    </message>
    <message>
        <source>columns: travel and travel_x say the same twice</source>
        <translation>columns: travel und travel_x sagen dasselbe zweimal</translation>
    </message>
    <message>
        <source>probe_radius is for points = 'centre'; contact points need none</source>
        <translation>probe_radius gehört zu points = 'centre'; Berührpunkte brauchen keinen</translation>
    </message>
    <message>
        <source>decimal and separator cannot both be the comma</source>
        <translation>decimal und separator können nicht beide das Komma sein</translation>
    </message>
    <message>
        <source>columns: {} is none of {}</source>
        <translation>columns: {} ist keine von {}</translation>
    </message>
    <message>
        <source>columns.{} is a name in the header or a number from 1, not {}</source>
        <translation>columns.{} ist ein Name der Kopfzeile oder eine Nummer ab 1, nicht {}</translation>
    </message>
    <message>
        <source>only: {} is a text or a list of texts, not {}</source>
        <translation>only: {} ist ein Text oder eine Liste von Texten, nicht {}</translation>
    </message>
    <message>
        <source>only: {} is no column</source>
        <translation>only: {} ist keine Spalte</translation>
    </message>
    <message>
        <source>columns: {} is missing</source>
        <translation>columns: {} fehlt</translation>
    </message>
    <message>
        <source>{} must be {}</source>
        <translation>{} muss sein: {}</translation>
    </message>
    <message>
        <source>two lengths in mm</source>
        <translation>zwei Längen in mm</translation>
    </message>
    <message>
        <source>within {} of the effective radius</source>
        <translation>innerhalb von {} um den wirksamen Radius</translation>
    </message>
    <message>
        <source>as many as directions, at least three</source>
        <translation>so viele wie Richtungen, mindestens drei</translation>
    </message>
    <message>
        <source>angles that increase and stay within one turn</source>
        <translation>steigende Winkel innerhalb einer Umdrehung</translation>
    </message>
    <message>
        <source>lengths in mm within {} of the effective radius</source>
        <translation>Längen in mm innerhalb von {} um den wirksamen Radius</translation>
    </message>
    <message>
        <source>linear where the directions are not evenly spaced round the turn</source>
        <translation>linear, wo die Richtungen nicht gleichmäßig über die Umdrehung verteilt sind</translation>
    </message>
    <message>
        <source>{}:{}: a coordinate is not a finite number</source>
        <translation>{}:{}: eine Koordinate ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>{}: ball radius {} is negative</source>
        <translation>{}: der Kugelradius {} ist negativ</translation>
    </message>
    <message>
        <source>{}: {} names for {} points</source>
        <translation>{}: {} Namen für {} Punkte</translation>
    </message>
    <message>
        <source>{}: the radii of a shift along an axis must be above 0 mm</source>
        <translation>{}: die Radien einer Verschiebung entlang einer Achse müssen über 0 mm liegen</translation>
    </message>
    <message>
        <source>a length in mm above 0</source>
        <translation>eine Länge in mm über 0</translation>
    </message>
    <message>
        <source>given together with radii</source>
        <translation>zusammen mit radii angegeben</translation>
    </message>
    <message>
        <source>{}: directions of travel are for points shifted along an axis</source>
        <translation>{}: Antastrichtungen gehören zu Punkten, die entlang einer Achse verschoben sind</translation>
    </message>
    <message>
        <source>{}: the direction of travel has not length 1</source>
        <translation>{}: die Antastrichtung hat nicht die Länge 1</translation>
    </message>
    <message>
        <source>number of the point</source>
        <translation>Nummer des Punkts</translation>
    </message>
    <message>
        <source>radius of the ball</source>
        <translation>Radius der Kugel</translation>
    </message>
    <message>
        <source>byte 0x{:02X} among the numbers: transmission has spoilt the line</source>
        <translation>Byte 0x{:02X} unter den Zahlen: die Übertragung hat die Zeile verdorben</translation>
    </message>
    <message>
        <source>G801 without its G800 line: a line was lost, send the results again</source>
        <translation>G801 ohne seine Zeile G800: eine Zeile ging verloren, senden Sie die Ergebnisse noch einmal</translation>
    </message>
    <message>
        <source>G801 of point {} follows G800 of point {} in line {}: lines were lost</source>
        <translation>G801 des Punkts {} folgt auf G800 des Punkts {} in Zeile {}: Zeilen gingen verloren</translation>
    </message>
    <message>
        <source>ball radius R{:g} is negative</source>
        <translation>der Kugelradius R{:g} ist negativ</translation>
    </message>
    <message>
        <source>N{:g} is no number of a point</source>
        <translation>N{:g} ist keine Punktnummer</translation>
    </message>
    <message>
        <source>G801 of point {} is missing after its G800 in line {}: send the results again</source>
        <translation>G801 des Punkts {} fehlt nach seinem G800 in Zeile {}: senden Sie die Ergebnisse noch einmal</translation>
    </message>
    <message>
        <source>G801 of point {} is missing: the file was cut off after this line</source>
        <translation>G801 des Punkts {} fehlt: die Datei wurde nach dieser Zeile abgeschnitten</translation>
    </message>
    <message>
        <source>, only {} features of probing cycles</source>
        <translation>, nur {} Merkmale aus Messzyklen</translation>
    </message>
    <message>
        <source>no measured points G800 and G801 in the file{}: the inspection printed none</source>
        <translation>keine Messpunkte G800 und G801 in der Datei{}: die Messung hat keine ausgegeben</translation>
    </message>
    <message>
        <source>{} features of probing cycles left out: COMPONENT, SIZE and POSN blocks</source>
        <translation>{} Merkmale aus Messzyklen weggelassen: Blöcke COMPONENT, SIZE und POSN</translation>
    </message>
    <message>
        <source>{} points have a nominal offset O, which is not applied</source>
        <translation>{} Punkte haben einen Sollversatz O, der nicht angewandt wird</translation>
    </message>
    <message>
        <source>no END: points may be missing at the end of the file</source>
        <translation>kein END: am Ende der Datei können Punkte fehlen</translation>
    </message>
    <message>
        <source>point N{} with the same nominal is there twice, first in line {}: keep one of them</source>
        <translation>Punkt N{} mit demselben Sollpunkt kommt zweimal vor, zuerst in Zeile {}: behalten Sie einen davon</translation>
    </message>
    <message>
        <source>{} points turned back by G330</source>
        <translation>{} Punkte von G330 zurückgedreht</translation>
    </message>
    <message>
        <source>{} points shifted by G330, after turning: compare with another export once</source>
        <translation>{} Punkte von G330 nach dem Drehen verschoben: vergleichen Sie sie einmal mit einer anderen Ausgabe</translation>
    </message>
    <message>
        <source>a line of {} characters: no MSR file, or damaged</source>
        <translation>eine Zeile von {} Zeichen: keine MSR-Datei, oder beschädigt</translation>
    </message>
    <message>
        <source>{}: {} is no letter with a number</source>
        <translation>{}: {} ist kein Buchstabe mit einer Zahl</translation>
    </message>
    <message>
        <source>{} has the letter {} twice: two lines ran together</source>
        <translation>{} hat den Buchstaben {} zweimal: zwei Zeilen sind ineinandergelaufen</translation>
    </message>
    <message>
        <source>{}: {}{} is no length, number or angle</source>
        <translation>{}: {}{} ist weder Länge noch Zahl noch Winkel</translation>
    </message>
    <message>
        <source>{} lacks {}, {}: the line is incomplete</source>
        <translation>{} fehlt {}, {}: die Zeile ist unvollständig</translation>
    </message>
    <message>
        <source>{} is no line of an MSR file: transmission may have spoilt it</source>
        <translation>{} ist keine Zeile einer MSR-Datei: die Übertragung kann sie verdorben haben</translation>
    </message>
    <message>
        <source>{} points in lines {} to {}</source>
        <translation>{} Punkte in den Zeilen {} bis {}</translation>
    </message>
    <message>
        <source>no points</source>
        <translation>keine Punkte</translation>
    </message>
    <message>
        <source>{} holds {} measured parts ({}): say which with {}</source>
        <translation>{} enthält {} gemessene Teile ({}): sagen Sie, welches, mit {}</translation>
    </message>
    <message>
        <source>one measured part</source>
        <translation>ein gemessenes Teil</translation>
    </message>
    <message>
        <source>{} measured parts, counted from 1</source>
        <translation>{} gemessene Teile, gezählt ab 1</translation>
    </message>
    <message>
        <source>{}: {} holds {}</source>
        <translation>{}: {} enthält {}</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{}: {}</translation>
    </message>
    <message>
        <source>{} to {}: {}</source>
        <translation>{} bis {}: {}</translation>
    </message>
    <message>
        <source>first alignment</source>
        <translation>erste Ausrichtung</translation>
    </message>
    <message>
        <source>after {} in line {}</source>
        <translation>nach {} in Zeile {}</translation>
    </message>
    <message>
        <source>{} lacks {} and is no point</source>
        <translation>{} fehlt {}, es ist kein Punkt</translation>
    </message>
    <message>
        <source>{} of {}</source>
        <translation>{} von {}</translation>
    </message>
    <message>
        <source>unit {}: only MM and IN are read</source>
        <translation>Einheit {}: nur MM und IN werden gelesen</translation>
    </message>
    <message>
        <source>a row of an axis without column heads (AX NOMINAL ...) above it</source>
        <translation>eine Achszeile ohne Spaltenköpfe (AX NOMINAL ...) darüber</translation>
    </message>
    <message>
        <source>whose row of axis {} is this? {} in line {} stands between it and {} of line {}: delete what is no line of the report</source>
        <translation>wessen Zeile der Achse {} ist das? {} in Zeile {} steht zwischen ihr und {} aus Zeile {}: löschen Sie, was keine Zeile des Protokolls ist</translation>
    </message>
    <message>
        <source>{} among the values of axis {}: export the report again</source>
        <translation>{} unter den Werten der Achse {}: geben Sie das Protokoll neu aus</translation>
    </message>
    <message>
        <source>a value is no length</source>
        <translation>ein Wert ist keine Länge</translation>
    </message>
    <message>
        <source>axis {}: DEV is not MEAS - NOMINAL in any way the columns can be read: export it again</source>
        <translation>Achse {}: DEV ist nicht MEAS - NOMINAL, wie man die Spalten auch liest: geben Sie es neu aus</translation>
    </message>
    <message>
        <source>axis {} of {} is there twice</source>
        <translation>Achse {} von {} kommt zweimal vor</translation>
    </message>
    <message>
        <source>{} locations left out: {} (line {})</source>
        <translation>{} Lagen weggelassen: {} (Zeile {})</translation>
    </message>
    <message>
        <source>dimensions left out: {}</source>
        <translation>Maße weggelassen: {}</translation>
    </message>
    <message>
        <source>no LOCATION OF POINT in the report: report the points' X, Y and Z</source>
        <translation>kein LOCATION OF POINT im Protokoll: geben Sie X, Y und Z der Punkte aus</translation>
    </message>
    <message>
        <source>points in different units: export them in one</source>
        <translation>Punkte in verschiedenen Einheiten: geben Sie sie in einer aus</translation>
    </message>
    <message>
        <source>{} of {} points have no V: normals are not used</source>
        <translation>{} von {} Punkten haben kein V: Normalen werden nicht verwendet</translation>
    </message>
    <message>
        <source>whose row of axis {} is this? {} in line {} closed {} of line {}</source>
        <translation>wessen Zeile der Achse {} ist das? {} in Zeile {} hat {} aus Zeile {} abgeschlossen</translation>
    </message>
    <message>
        <source>the vector V has no three components</source>
        <translation>der Vektor V hat nicht drei Komponenten</translation>
    </message>
    <message>
        <source>no point has all its axes: {}; report X, Y and Z</source>
        <translation>kein Punkt hat alle seine Achsen: {}; geben Sie X, Y und Z aus</translation>
    </message>
    <message>
        <source>{} is no row of an axis: export the report again</source>
        <translation>{} ist keine Achszeile: geben Sie das Protokoll neu aus</translation>
    </message>
    <message>
        <source>no single column {}: print nominal, measured value and deviation</source>
        <translation>keine eindeutige Spalte {}: geben Sie Soll, Ist und Abweichung aus</translation>
    </message>
    <message>
        <source>{} lies elsewhere than in line {}: report every point once</source>
        <translation>{} liegt anderswo als in Zeile {}: geben Sie jeden Punkt einmal aus</translation>
    </message>
    <message>
        <source>X3P file</source>
        <translation>X3P-Datei</translation>
    </message>
    <message>
        <source>no points: it has {} instead of x, y, z</source>
        <translation>keine Punkte: sie hat {} statt x, y, z</translation>
    </message>
    <message>
        <source>x, y and z are no numbers</source>
        <translation>x, y und z sind keine Zahlen</translation>
    </message>
    <message>
        <source>the header tells of more elements than the file can hold: it was cut off</source>
        <translation>der Kopf nennt mehr Elemente, als die Datei fassen kann: sie wurde abgeschnitten</translation>
    </message>
    <message>
        <source>no points: it has no element named vertex</source>
        <translation>keine Punkte: sie hat kein Element namens vertex</translation>
    </message>
    <message>
        <source>the corners of a mesh are taken as points</source>
        <translation>die Ecken eines Netzes gelten als Punkte</translation>
    </message>
    <message>
        <source>the header lacks POINTS or DATA</source>
        <translation>im Kopf fehlt POINTS oder DATA</translation>
    </message>
    <message>
        <source>the header tells of more points than the file can hold: it was cut off</source>
        <translation>der Kopf nennt mehr Punkte, als die Datei fassen kann: sie wurde abgeschnitten</translation>
    </message>
    <message>
        <source>the header tells of {} numbers a point: it is damaged</source>
        <translation>der Kopf nennt {} Zahlen je Punkt: er ist beschädigt</translation>
    </message>
    <message>
        <source>{} points where the header says {}: the file was cut off</source>
        <translation>{} Punkte, wo der Kopf {} nennt: die Datei wurde abgeschnitten</translation>
    </message>
    <message>
        <source>{} scans put together</source>
        <translation>{} Scans zusammengefügt</translation>
    </message>
    <message>
        <source>{} layers put together</source>
        <translation>{} Schichten zusammengefügt</translation>
    </message>
    <message>
        <source>a profile: its X and Z are the contour's X and Y</source>
        <translation>ein Profilschnitt: sein X und Z sind X und Y der Kontur</translation>
    </message>
    <message>
        <source>no {} file</source>
        <translation>keine {}-Datei</translation>
    </message>
    <message>
        <source>{} points without a place left out</source>
        <translation>{} Punkte ohne Ort weggelassen</translation>
    </message>
    <message>
        <source>coordinates are stored in steps of {}, at {}</source>
        <translation>Koordinaten sind in Schritten von {} gespeichert, bei {}</translation>
    </message>
    <message>
        <source>the compressed data are damaged or cut off</source>
        <translation>die komprimierten Daten sind beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>{} files are read by the Python package {}, which is not installed: pip install {}</source>
        <translation>{}-Dateien liest das Python-Paket {}, das nicht installiert ist: pip install {}</translation>
    </message>
    <message>
        <source>{} cannot read it, {}: the file is damaged or cut off</source>
        <translation>{} kann sie nicht lesen, {}: die Datei ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>the normals are no numbers</source>
        <translation>die Normalen sind keine Zahlen</translation>
    </message>
    <message>
        <source>a scan tells of more points than the file can hold</source>
        <translation>ein Scan nennt mehr Punkte, als die Datei fassen kann</translation>
    </message>
    <message>
        <source>probe</source>
        <translation>Taster</translation>
    </message>
    <message>
        <source>{} from {:g} to {:g}</source>
        <translation>{} von {:g} bis {:g}</translation>
    </message>
    <message>
        <source>name is a text, not {}</source>
        <translation>name ist ein Text, nicht {}</translation>
    </message>
    <message>
        <source>{} is missing: the two go together</source>
        <translation>{} fehlt: die beiden gehören zusammen</translation>
    </message>
    <message>
        <source>interpolation is {}, not {}</source>
        <translation>interpolation ist {}, nicht {}</translation>
    </message>
    <message>
        <source>radius is missing: the effective radius of the ball in mm</source>
        <translation>radius fehlt: der wirksame Radius der Kugel in mm</translation>
    </message>
    <message>
        <source>a list of at least 3 numbers</source>
        <translation>eine Liste von mindestens 3 Zahlen</translation>
    </message>
    <message>
        <source>a list of {} numbers</source>
        <translation>eine Liste von {} Zahlen</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a number is too large</source>
        <translation>eine Zahl ist zu groß</translation>
    </message>
    <message>
        <source>{} rays that met nothing left out</source>
        <translation>{} Strahlen, die nichts trafen, weggelassen</translation>
    </message>
    <message>
        <source>no measured points in the file</source>
        <translation>keine Messpunkte in der Datei</translation>
    </message>
    <message>
        <source>the head of a scan is not whole: four lines of three numbers, four of four</source>
        <translation>der Kopf eines Scans ist nicht vollständig: vier Zeilen mit drei Zahlen, vier mit vier</translation>
    </message>
    <message>
        <source>the matrix of a scan is no turn and shift</source>
        <translation>die Matrix eines Scans ist keine Drehung mit Verschiebung</translation>
    </message>
    <message>
        <source>{} points where {} are announced: the file was cut off</source>
        <translation>{} Punkte, wo {} angekündigt sind: die Datei wurde abgeschnitten</translation>
    </message>
    <message>
        <source>{} is no number of points: lines are missing or too many</source>
        <translation>{} ist keine Anzahl von Punkten: Zeilen fehlen oder sind zu viel</translation>
    </message>
    <message>
        <source>{} numbers are no point: {}</source>
        <translation>{} Zahlen sind kein Punkt: {}</translation>
    </message>
    <message>
        <source>{} is neither a K field nor a line of values</source>
        <translation>{} ist weder ein K-Feld noch eine Zeile von Werten</translation>
    </message>
    <message>
        <source>K{}/{} is there twice with different contents</source>
        <translation>K{}/{} kommt zweimal mit verschiedenem Inhalt vor</translation>
    </message>
    <message>
        <source>a value of characteristic {}, which no K2 field describes</source>
        <translation>ein Wert des Merkmals {}, das kein K2-Feld beschreibt</translation>
    </message>
    <message>
        <source>{} values for {} characteristics: the line is incomplete, or this is no line of values</source>
        <translation>{} Werte für {} Merkmale: die Zeile ist unvollständig, oder das ist keine Zeile von Werten</translation>
    </message>
    <message>
        <source>K0100 says {} characteristics, there are {}: the file was cut off or put together</source>
        <translation>K0100 nennt {} Merkmale, es sind {}: die Datei wurde abgeschnitten oder zusammengesetzt</translation>
    </message>
    <message>
        <source>none of the points was measured on this part</source>
        <translation>keiner der Punkte wurde an diesem Teil gemessen</translation>
    </message>
    <message>
        <source>{} characteristics are no coordinate of a point</source>
        <translation>{} Merkmale sind keine Koordinate eines Punkts</translation>
    </message>
    <message>
        <source>{} points were not measured on this part</source>
        <translation>{} Punkte wurden an diesem Teil nicht gemessen</translation>
    </message>
    <message>
        <source>no points: name the characteristics of a point alike with X, Y and Z, such as P1.X, P1.Y, P1.Z</source>
        <translation>keine Punkte: benennen Sie die Merkmale eines Punkts gleich, mit X, Y und Z, etwa P1.X, P1.Y, P1.Z</translation>
    </message>
    <message>
        <source>no values: the file describes characteristics and holds no results</source>
        <translation>keine Werte: die Datei beschreibt Merkmale und enthält keine Ergebnisse</translation>
    </message>
    <message>
        <source>{} of point {} has {} of {} values: the file was cut off, or K0002 256 is missing for a point that was not measured</source>
        <translation>{} des Punkts {} hat {} von {} Werten: die Datei wurde abgeschnitten, oder K0002 256 fehlt für einen Punkt, der nicht gemessen wurde</translation>
    </message>
    <message>
        <source>coordinates in mm and in inch in one file</source>
        <translation>Koordinaten in mm und in Zoll in einer Datei</translation>
    </message>
    <message>
        <source>point {} has no Z, others have</source>
        <translation>Punkt {} hat kein Z, andere schon</translation>
    </message>
    <message>
        <source>K0100 {} is no number of characteristics</source>
        <translation>K0100 {} ist keine Anzahl von Merkmalen</translation>
    </message>
    <message>
        <source>{} of point {} is there twice, first in line {}</source>
        <translation>{} des Punkts {} kommt zweimal vor, zuerst in Zeile {}</translation>
    </message>
    <message>
        <source>part {}</source>
        <translation>Teil {}</translation>
    </message>
    <message>
        <source>the profile values stored in the file</source>
        <translation>die in der Datei gespeicherten Profilwerte</translation>
    </message>
    <message>
        <source>the file's other points</source>
        <translation>die anderen Punkte der Datei</translation>
    </message>
    <message>
        <source>result {} in line {}</source>
        <translation>Ergebnis {} in Zeile {}</translation>
    </message>
    <message>
        <source>more than one primary unit of length</source>
        <translation>mehr als eine Haupteinheit der Länge</translation>
    </message>
    <message>
        <source>{} names no unit of length</source>
        <translation>{} nennt keine Längeneinheit</translation>
    </message>
    <message>
        <source>unit {} is not among the file's units</source>
        <translation>die Einheit {} ist nicht unter den Einheiten der Datei</translation>
    </message>
    <message>
        <source>no measured points; {} measured features without any</source>
        <translation>keine Messpunkte; {} gemessene Merkmale ohne solche</translation>
    </message>
    <message>
        <source>point set {}: its ProbeRadius is not positive</source>
        <translation>Punktsatz {}: sein ProbeRadius ist nicht positiv</translation>
    </message>
    <message>
        <source>points left out: {}</source>
        <translation>Punkte weggelassen: {}</translation>
    </message>
    <message>
        <source>measured point {} has no Location</source>
        <translation>Messpunkt {} hat keine Location</translation>
    </message>
    <message>
        <source>points {} to {} are wanted of point set {}, which has {}</source>
        <translation>die Punkte {} bis {} des Punktsatzes {} werden verlangt, der {} hat</translation>
    </message>
    <message>
        <source>{} locations are taken for what the file's others are</source>
        <translation>{} Orte gelten als das, was die anderen der Datei sind</translation>
    </message>
    <message>
        <source>stored profile values differ from (P - N) . n - r by up to {}</source>
        <translation>gespeicherte Profilwerte weichen um bis zu {} von (P - N) . n - r ab</translation>
    </message>
    <message>
        <source>{} contradicts {}: {} points are ball centres</source>
        <translation>{} widerspricht {}: {} Punkte sind Kugelmittelpunkte</translation>
    </message>
    <message>
        <source>{} contradicts {}: {} are contact points</source>
        <translation>{} widerspricht {}: {} sind Berührpunkte</translation>
    </message>
    <message>
        <source>the unit named {} has the factor {:g} to metres, not {:g}: one of them is wrong, export the file again</source>
        <translation>die Einheit namens {} hat den Faktor {:g} zum Meter, nicht {:g}: eines davon ist falsch, geben Sie die Datei neu aus</translation>
    </message>
    <message>
        <source>{} of {} features</source>
        <translation>{} von {} Merkmalen</translation>
    </message>
    <message>
        <source>feature item {} refers to nominal {}, which is not in the file</source>
        <translation>das Merkmal {} verweist auf das Sollmerkmal {}, das nicht in der Datei ist</translation>
    </message>
    <message>
        <source>measured point {} refers to feature item {}, which is not in the file</source>
        <translation>Messpunkt {} verweist auf das Merkmal {}, das nicht in der Datei ist</translation>
    </message>
    <message>
        <source>of feature {}</source>
        <translation>des Merkmals {}</translation>
    </message>
    <message>
        <source>point set {}: </source>
        <translation>Punktsatz {}: </translation>
    </message>
    <message>
        <source>element {}: </source>
        <translation>Element {}: </translation>
    </message>
    <message>
        <source>{} is no range of points of set {}</source>
        <translation>{} ist kein Bereich von Punkten des Satzes {}</translation>
    </message>
    <message>
        <source>{:g} m is no unit of length</source>
        <translation>{:g} m ist keine Längeneinheit</translation>
    </message>
    <message>
        <source>a feature or point set has no id</source>
        <translation>ein Merkmal oder Punktsatz hat keine id</translation>
    </message>
    <message>
        <source>id {} is there twice, first in line {}</source>
        <translation>id {} kommt zweimal vor, zuerst in Zeile {}</translation>
    </message>
    <message>
        <source>a MeasurePoint of feature {} has no Point</source>
        <translation>ein MeasurePoint des Merkmals {} hat keinen Point</translation>
    </message>
    <message>
        <source>feature {}: Compensated {} is not true or false</source>
        <translation>Merkmal {}: Compensated {} ist weder true noch false</translation>
    </message>
    <message>
        <source>a MeasurePoint of feature {} lacks Compensated, or all others do</source>
        <translation>einem MeasurePoint des Merkmals {} fehlt Compensated, oder allen anderen</translation>
    </message>
    <message>
        <source>point set {} has no count</source>
        <translation>Punktsatz {} hat keine Anzahl</translation>
    </message>
    <message>
        <source>point set {} has no Points</source>
        <translation>Punktsatz {} hat keine Points</translation>
    </message>
    <message>
        <source>point set {} has its own {}: export the points in the common frame and unit</source>
        <translation>Punktsatz {} hat ein eigenes {}: geben Sie die Punkte im gemeinsamen System und in der gemeinsamen Einheit aus</translation>
    </message>
    <message>
        <source>point set {}: {} {} is not true or false</source>
        <translation>Punktsatz {}: {} {} ist weder true noch false</translation>
    </message>
    <message>
        <source>point set {}: {} has {} bytes for {} points</source>
        <translation>Punktsatz {}: {} hat {} Bytes für {} Punkte</translation>
    </message>
    <message>
        <source>{}{} numbers where {} were expected</source>
        <translation>{}{} Zahlen, wo {} erwartet wurden</translation>
    </message>
    <message>
        <source>{}{:g} is no length that a machine can travel</source>
        <translation>{}{:g} ist keine Länge, die eine Maschine fahren kann</translation>
    </message>
    <message>
        <source>point set {}: {} is no base64</source>
        <translation>Punktsatz {}: {} ist kein base64</translation>
    </message>
    <message>
        <source>{}{} is no number</source>
        <translation>{}{} ist keine Zahl</translation>
    </message>
    <message>
        <source>the measurement</source>
        <translation>die Messung</translation>
    </message>
    <message>
        <source>{} says nothing of how to read a file; known are {}</source>
        <translation>{} sagt nichts darüber, wie eine Datei zu lesen ist; bekannt sind {}</translation>
    </message>
    <message>
        <source>component {}, {}</source>
        <translation>Bauteil {}, {}</translation>
    </message>
    <message>
        <source>{} is no whole POSN line: print the results again</source>
        <translation>{} ist keine ganze POSN-Zeile: geben Sie die Ergebnisse neu aus</translation>
    </message>
    <message>
        <source>a POSN line without COMPONENT NO and FEATURE NO above it</source>
        <translation>eine POSN-Zeile ohne COMPONENT NO und FEATURE NO darüber</translation>
    </message>
    <message>
        <source>a value is no length that a machine can travel</source>
        <translation>ein Wert ist keine Länge, die eine Maschine fahren kann</translation>
    </message>
    <message>
        <source>axis {}: DEV is not ACTUAL less nominal, the line is damaged</source>
        <translation>Achse {}: DEV ist nicht ACTUAL minus Soll, die Zeile ist beschädigt</translation>
    </message>
    <message>
        <source>axis {} of feature {} is there twice</source>
        <translation>Achse {} des Merkmals {} kommt zweimal vor</translation>
    </message>
    <message>
        <source>none of {} features has POSN X and POSN Y without SIZE: measure the contour by points</source>
        <translation>keines von {} Merkmalen hat POSN X und POSN Y ohne SIZE: messen Sie die Kontur punktweise</translation>
    </message>
    <message>
        <source>feature {} has no POSN Z, others have</source>
        <translation>Merkmal {} hat kein POSN Z, andere schon</translation>
    </message>
    <message>
        <source>component and feature {} are there twice: keep one print-out</source>
        <translation>Bauteil und Merkmal {} kommen zweimal vor: behalten Sie einen Ausdruck</translation>
    </message>
    <message>
        <source>{} features left out: measured along one axis only, as feature {} (line {}); print where the ball stood</source>
        <translation>{} Merkmale weggelassen: nur entlang einer Achse gemessen, wie Merkmal {} (Zeile {}); geben Sie aus, wo die Kugel stand</translation>
    </message>
    <message>
        <source>{} features with a size left out</source>
        <translation>{} Merkmale mit einer Größe weggelassen</translation>
    </message>
    <message>
        <source>{} features have an axis that was not measured (ACTUAL NaN)</source>
        <translation>{} Merkmale haben eine Achse, die nicht gemessen wurde (ACTUAL NaN)</translation>
    </message>
    <message>
        <source>{} features without POSN of X and Y left out</source>
        <translation>{} Merkmale ohne POSN von X und Y weggelassen</translation>
    </message>
    <message>
        <source>contact points</source>
        <translation>Berührpunkte</translation>
    </message>
    <message>
        <source>centres of the probe ball</source>
        <translation>Mittelpunkte der Tasterkugel</translation>
    </message>
    <message>
        <source>shifted along an axis</source>
        <translation>entlang einer Achse verschoben</translation>
    </message>
    <message>
        <source>normal i,j,k</source>
        <translation>Normale i,j,k</translation>
    </message>
    <message>
        <source>a line of {} characters: not a measurement file, or damaged</source>
        <translation>eine Zeile von {} Zeichen: keine Messdatei, oder beschädigt</translation>
    </message>
    <message>
        <source>coordinate</source>
        <translation>Koordinate</translation>
    </message>
    <message>
        <source>{} points of another probe ball moved along their normals to {}</source>
        <translation>{} Punkte einer anderen Tasterkugel entlang ihrer Normalen auf {} verschoben</translation>
    </message>
    <message>
        <source>the {} has length {}, not 1: export unit vectors or leave the columns out</source>
        <translation>{}: Länge {}, nicht 1: geben Sie Einheitsvektoren aus, oder lassen Sie die Spalten weg</translation>
    </message>
    <message>
        <source>{} contradicts {}, which says {}</source>
        <translation>{} widerspricht {}: dort steht {}</translation>
    </message>
    <message>
        <source>{} contradicts {}, whose points are {}: leave {} out</source>
        <translation>{} widerspricht {}, deren Punkte {} sind: lassen Sie {} weg</translation>
    </message>
    <message>
        <source>the file does not say whether its coordinates are contact points or centres of the probe ball</source>
        <translation>die Datei sagt nicht, ob ihre Koordinaten Berührpunkte oder Mittelpunkte der Tasterkugel sind</translation>
    </message>
    <message>
        <source>ball centres need {}, the radius of the probe ball: {} does not say it</source>
        <translation>Kugelmittelpunkte brauchen {}, den Radius der Tasterkugel: {} sagt ihn nicht</translation>
    </message>
    <message>
        <source>{} contradicts control_radius in the probe's file: leave one of them out</source>
        <translation>{} widerspricht control_radius in der Datei des Tasters: lassen Sie eines davon weg</translation>
    </message>
    <message>
        <source>{} contradicts {}, which says {}: leave {} out</source>
        <translation>{} widerspricht {}: dort steht {}: lassen Sie {} weg</translation>
    </message>
    <message>
        <source>a probe radius of {} contradicts {}, which says {}: they differ by more than a calibration can</source>
        <translation>ein Tasterradius von {} widerspricht {}: dort steht {}: mehr Unterschied, als eine Kalibrierung ergeben kann</translation>
    </message>
    <message>
        <source>radii by direction do not say by which one the control shifted: add {}</source>
        <translation>Radien je Richtung sagen nicht, um welchen die Steuerung verschoben hat: geben Sie {} dazu an</translation>
    </message>
    <message>
        <source>nominal coordinate</source>
        <translation>Sollkoordinate</translation>
    </message>
    <message>
        <source>{} is no radius of a probe ball</source>
        <translation>{} ist kein Radius einer Tasterkugel</translation>
    </message>
    <message>
        <source>probe balls of {} and {} radius and no normals: give one file a ball</source>
        <translation>Tasterkugeln von {} und {} Radius und keine Normalen: geben Sie je Datei eine Kugel</translation>
    </message>
    <message>
        <source> (or axis)</source>
        <translation> (oder Achse)</translation>
    </message>
    <message>
        <source>points shifted along an axis need {}, the radius by which the control shifted them</source>
        <translation>entlang einer Achse verschobene Punkte brauchen {}, den Radius, um den die Steuerung sie verschoben hat</translation>
    </message>
    <message>
        <source>a {} is no length that a machine can travel</source>
        <translation>{}: keine Länge, die eine Maschine fahren kann</translation>
    </message>
    <message>
        <source>the file does not say</source>
        <translation>die Datei sagt es nicht</translation>
    </message>
    <message>
        <source>the probe</source>
        <translation>dem Taster</translation>
    </message>
    <message>
        <source>the {} corners of a mesh of {} facets are taken as points, with its normals</source>
        <translation>die {} Ecken eines Netzes von {} Facetten gelten als Punkte, mit seinen Normalen</translation>
    </message>
    <message>
        <source>{} corners without a normal left out</source>
        <translation>{} Ecken ohne Normale weggelassen</translation>
    </message>
    <message>
        <source>coordinates are stored in steps of {:.2g} {}, at the farthest</source>
        <translation>Koordinaten sind in Schritten von {:.2g} {} gespeichert, am weitesten außen</translation>
    </message>
    <message>
        <source>a corner is no place</source>
        <translation>eine Ecke ist kein Ort</translation>
    </message>
    <message>
        <source>{} is no whole facet: damaged or cut off</source>
        <translation>{} ist keine ganze Facette: beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>no STL file, or one that was cut off: its size does not fit its count of facets</source>
        <translation>keine STL-Datei, oder eine abgeschnittene: ihre Größe passt nicht zur Zahl ihrer Facetten</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>das Ende</translation>
    </message>
    <message>
        <source>{} columns where {} were expected</source>
        <translation>{} Spalten, wo {} erwartet wurden</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>radii by direction</source>
        <translation>Radien je Richtung</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>{}: decimal commas between commas? Export with decimal points, or semicolons between</source>
        <translation>{}: Dezimalkommas zwischen Kommas? Geben Sie Dezimalpunkte aus, oder Strichpunkte dazwischen</translation>
    </message>
    <message>
        <source>{}: the row is incomplete or the file was cut off; {}</source>
        <translation>{}: die Zeile ist unvollständig, oder die Datei wurde abgeschnitten; {}</translation>
    </message>
    <message>
        <source>{} contradicts {}, whose header says {}</source>
        <translation>{} widerspricht {}, deren Kopfzeile {} sagt</translation>
    </message>
    <message>
        <source>a coordinate is too large</source>
        <translation>eine Koordinate ist zu groß</translation>
    </message>
    <message>
        <source>points shifted along an axis are kept in the file they came from: leave {} out</source>
        <translation>entlang einer Achse verschobene Punkte bleiben in ihrer Datei: lassen Sie {} weg</translation>
    </message>
    <message>
        <source>a text file cannot keep the {} of {}, and the points are wrong without: say {} in its place here, and {} with the written file</source>
        <translation>eine Textdatei kann {} von {} nicht bewahren, und ohne das sind die Punkte falsch: geben Sie hier stattdessen {} an, und {} bei der geschriebenen Datei</translation>
    </message>
    <message>
        <source>{} can be a decimal comma or a thousands separator: export with decimal points, or with semicolons between the columns</source>
        <translation>{} kann ein Dezimalkomma oder ein Tausendertrennzeichen sein: geben Sie Dezimalpunkte aus, oder Strichpunkte zwischen den Spalten</translation>
    </message>
    <message>
        <source>expected a header x,y,z or x,y,z,i,j,k above the numbers (or say {})</source>
        <translation>erwartet wurde eine Kopfzeile x,y,z oder x,y,z,i,j,k über den Zahlen (oder geben Sie {} an)</translation>
    </message>
    <message>
        <source>{}, found {}</source>
        <translation>{}, gefunden wurde {}</translation>
    </message>
    <message>
        <source>no header: the first column {}, then {}; a header says otherwise</source>
        <translation>keine Kopfzeile: die erste Spalte {}, dann {}; eine Kopfzeile sagt es anders</translation>
    </message>
    <message>
        <source>counts up from {}: the points' numbers</source>
        <translation>zählt von {} aufwärts: die Nummern der Punkte</translation>
    </message>
    <message>
        <source>{} columns without a header: {}; a mapping for it: {}</source>
        <translation>{} Spalten ohne Kopfzeile: {}; eine Zuordnung dafür: {}</translation>
    </message>
    <message>
        <source>no points: the file holds only comments</source>
        <translation>keine Punkte: die Datei enthält nur Kommentare</translation>
    </message>
    <message>
        <source>{}; a mapping for it: {}</source>
        <translation>{}; eine Zuordnung dafür: {}</translation>
    </message>
    <message>
        <source>unit {}: only mm and inch are read, convert the file</source>
        <translation>Einheit {}: nur mm und Zoll werden gelesen, rechnen Sie die Datei um</translation>
    </message>
    <message>
        <source>column {} is missing: a normal needs i,j,k</source>
        <translation>Spalte {} fehlt: eine Normale braucht i,j,k</translation>
    </message>
    <message>
        <source>columns i and j are missing: a normal needs i,j,k</source>
        <translation>die Spalten i und j fehlen: eine Normale braucht i,j,k</translation>
    </message>
    <message>
        <source>the header gives the columns different units</source>
        <translation>die Kopfzeile gibt den Spalten verschiedene Einheiten</translation>
    </message>
    <message>
        <source>commas without a header can be decimal commas or separators: export with decimal points, or put a header x,y,z above the numbers</source>
        <translation>Kommas ohne Kopfzeile können Dezimalkommas oder Trennzeichen sein: geben Sie Dezimalpunkte aus, oder setzen Sie eine Kopfzeile x,y,z über die Zahlen</translation>
    </message>
    <message>
        <source>a line of {} characters: {}</source>
        <translation>eine Zeile von {} Zeichen: {}</translation>
    </message>
    <message>
        <source>holds words: the points' names</source>
        <translation>enthält Wörter: die Namen der Punkte</translation>
    </message>
    <message>
        <source>column {} appears twice: rename the one that was not measured</source>
        <translation>Spalte {} kommt zweimal vor: benennen Sie die nicht gemessene um</translation>
    </message>
    <message>
        <source>too large for a {}</source>
        <translation>{}: Datei zu groß</translation>
    </message>
    <message>
        <source>the {} cannot be read: {}</source>
        <translation>{}: nicht lesbar: {}</translation>
    </message>
    <message>
        <source>the {} is no text in UTF-8</source>
        <translation>{}: kein Text in UTF-8</translation>
    </message>
    <message>
        <source>no TOML: {}</source>
        <translation>kein TOML: {}</translation>
    </message>
    <message>
        <source>no TOML that describes a {}</source>
        <translation>kein TOML, das eine(n) {} beschreibt</translation>
    </message>
    <message>
        <source>did you mean {}?</source>
        <translation>meinten Sie {}?</translation>
    </message>
    <message>
        <source>a {} has {}</source>
        <translation>zu {} gehören {}</translation>
    </message>
    <message>
        <source>{} is no key of a {}: {}</source>
        <translation>{} ist kein Schlüssel für {}: {}</translation>
    </message>
    <message>
        <source>{} places touched twice: the second touch of each counts, the slow one</source>
        <translation>{} Orte zweimal angetastet: die zweite, langsame Antastung zählt</translation>
    </message>
    <message>
        <source>{}: the points are shifted along an axis of the machine and are to be turned by {:g} degrees: give the direction of travel of each point, and one radius</source>
        <translation>{}: die Punkte sind entlang einer Achse der Maschine verschoben und sollen um {:g} Grad gedreht werden: geben Sie die Antastrichtung jedes Punkts an, und einen Radius</translation>
    </message>
    <message>
        <source>the file ends within a number: it was cut off, or a spreadsheet dropped the last zeros; export it again, or end the last line</source>
        <translation>die Datei endet in einer Zahl: sie wurde abgeschnitten, oder eine Tabellenkalkulation hat die letzten Nullen gestrichen; geben Sie sie neu aus, oder beenden Sie die letzte Zeile</translation>
    </message>
    <message>
        <source>laid into the work frame at X{:g} Y{:g} Z{:g}{} of the file's frame, as given</source>
        <translation>ins Werkstücksystem bei X{:g} Y{:g} Z{:g}{} des Dateisystems gelegt, wie angegeben</translation>
    </message>
    <message>
        <source>, turned by {:g} deg</source>
        <translation>, um {:g} Grad gedreht</translation>
    </message>
    <message>
        <source>, the one shown of {}</source>
        <translation>, das angezeigte von {}</translation>
    </message>
    <message>
        <source>sheet {} of the workbook{}</source>
        <translation>Blatt {} der Arbeitsmappe{}</translation>
    </message>
    <message>
        <source>no workbook</source>
        <translation>keine Arbeitsmappe</translation>
    </message>
    <message>
        <source>sheet {} is empty: save the workbook with the sheet of the points shown</source>
        <translation>Blatt {} ist leer: speichern Sie die Arbeitsmappe, während das Blatt der Punkte angezeigt wird</translation>
    </message>
    <message>
        <source>{} workbooks are read by the Python package {}, which is not installed: pip install {}, or save the points as CSV</source>
        <translation>{}-Arbeitsmappen liest das Python-Paket {}, das nicht installiert ist: pip install {}, oder speichern Sie die Punkte als CSV</translation>
    </message>
    <message>
        <source>{} cannot read it, {}: the workbook is damaged or cut off</source>
        <translation>{} kann sie nicht lesen, {}: die Arbeitsmappe ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>the {} is damaged or cut off: save it again</source>
        <translation>{}: beschädigt oder abgeschnitten: speichern Sie noch einmal</translation>
    </message>
    <message>
        <source>the {} unpacks to absurd sizes: not one of points</source>
        <translation>{}: entpackt sich auf unsinnige Größen: enthält keine Punkte</translation>
    </message>
    <message>
        <source>the {}'s XML declares a document type: save it again</source>
        <translation>{}: das XML enthält eine Dokumenttypdeklaration: speichern Sie noch einmal</translation>
    </message>
    <message>
        <source>the XML declares a document type or an entity, which measurement files do not need: remove it</source>
        <translation>das XML enthält eine Dokumenttypdeklaration oder eine Entität, die Messdateien nicht brauchen: entfernen Sie sie</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>beschädigt</translation>
    </message>
    <message>
        <source>not well-formed XML ({}): the file is damaged or cut off</source>
        <translation>kein wohlgeformtes XML ({}): die Datei ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>XML in an unknown encoding ({}): save it as UTF-8</source>
        <translation>XML in unbekannter Kodierung ({}): speichern Sie es als UTF-8</translation>
    </message>
    <message>
        <source>the XML is {}, not {}</source>
        <translation>das XML ist {}, nicht {}</translation>
    </message>
    <message>
        <source>{} stands where the text of an element was expected</source>
        <translation>{} steht, wo der Text eines Elements erwartet wurde</translation>
    </message>
    <message>
        <source>elements nested deeper than {}: not a measurement file</source>
        <translation>Elemente tiefer geschachtelt als {}: keine Messdatei</translation>
    </message>
    <message>
        <source>the first line does not begin with XYZIJK</source>
        <translation>die erste Zeile beginnt nicht mit XYZIJK</translation>
    </message>
    <message>
        <source>{} circles left out: rows of 4 or 7 numbers are no points</source>
        <translation>{} Kreise weggelassen: Zeilen von 4 oder 7 Zahlen sind keine Punkte</translation>
    </message>
    <message>
        <source>no METRIC in the first line: taken for inch, as PC-DMIS does; {} says otherwise</source>
        <translation>kein METRIC in der ersten Zeile: als Zoll gelesen, wie PC-DMIS es tut; {} sagt es anders</translation>
    </message>
    <message>
        <source>no points in the file{}</source>
        <translation>keine Punkte in der Datei{}</translation>
    </message>
    <message>
        <source>no METRIC in the first line, which PC-DMIS takes for inch</source>
        <translation>kein METRIC in der ersten Zeile, was PC-DMIS als Zoll versteht</translation>
    </message>
    <message>
        <source>{} behind XYZIJK: only METRIC may stand there, in columns 11 to 16</source>
        <translation>{} hinter XYZIJK: nur METRIC darf dort stehen, in den Spalten 11 bis 16</translation>
    </message>
    <message>
        <source>METRIC stands in column {} of {}, not 11, where PC-DMIS takes the file for inch</source>
        <translation>METRIC steht in Spalte {} von {}, nicht 11, und PC-DMIS liest die Datei dann in Zoll</translation>
    </message>
    <message>
        <source>{} numbers: a point has 3, or 6 with its normal</source>
        <translation>{} Zahlen: ein Punkt hat 3, oder 6 mit seiner Normale</translation>
    </message>
    <message>
        <source>, only circles</source>
        <translation>, nur Kreise</translation>
    </message>
    <message>
        <source>{} needs measured points: what is predicted is no result of an inspection</source>
        <translation>{} braucht Messpunkte: Vorhergesagtes ist kein Prüfergebnis</translation>
    </message>
    <message>
        <source>Serial production</source>
        <translation>Serienfertigung</translation>
    </message>
    <message>
        <source>part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>time (UTC)</source>
        <translation>Zeit (UTC)</translation>
    </message>
    <message>
        <source>std</source>
        <translation>Std.-Abw.</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Spanne</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>größte</translation>
    </message>
    <message>
        <source>smoothed</source>
        <translation>geglättet</translation>
    </message>
    <message>
        <source>correction</source>
        <translation>Korrektur</translation>
    </message>
    <message>
        <source>decision</source>
        <translation>Entscheidung</translation>
    </message>
    <message>
        <source>First program, SHA-256</source>
        <translation>Erstes Programm, SHA-256</translation>
    </message>
    <message>
        <source>Program for the next part</source>
        <translation>Programm für das nächste Teil</translation>
    </message>
    <message>
        <source>What the machine does</source>
        <translation>Was die Maschine tut</translation>
    </message>
    <message>
        <source>Settings of part {}</source>
        <translation>Einstellungen von Teil {}</translation>
    </message>
    <message>
        <source>magnification {:g}: must be from 1 to {:.0f}</source>
        <translation>Vergrößerung {:g}: muss zwischen 1 und {:.0f} liegen</translation>
    </message>
    <message>
        <source>Read back, the program keeps the exact path to {}, within its tolerance of {}.</source>
        <translation>Zurückgelesen hält das Programm die genaue Bahn auf {} ein, innerhalb seiner Toleranz von {}.</translation>
    </message>
    <message>
        <source>Read back, the program keeps the exact path to {}, &lt;b&gt;outside&lt;/b&gt; its tolerance of {}.</source>
        <translation>Zurückgelesen hält das Programm die genaue Bahn auf {} ein, &lt;b&gt;außerhalb&lt;/b&gt; seiner Toleranz von {}.</translation>
    </message>
    <message>
        <source>The random part is not known here, so the prediction is too favourable: the next part brings its own, and what was random on this part comes on top.</source>
        <translation>Der zufällige Anteil ist hier nicht bekannt, die Vorhersage daher zu günstig: das nächste Teil bringt seinen eigenen mit, und was an diesem Teil zufällig war, kommt hinzu.</translation>
    </message>
    <message>
        <source>The emitted program was read back and its path compared with the exact parallel of the compensated profile.</source>
        <translation>Das geschriebene Programm wurde zurückgelesen und seine Bahn mit der genauen Parallelen des korrigierten Profils verglichen.</translation>
    </message>
    <message>
        <source>Side of the cutter</source>
        <translation>Seite des Fräsers</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Einpassung</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Limit of a correction</source>
        <translation>Grenze einer Korrektur</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Totband</translation>
    </message>
    <message>
        <source>Tolerance of the path</source>
        <translation>Toleranz der Bahn</translation>
    </message>
    <message>
        <source>Kinds of move written</source>
        <translation>Geschriebene Wegarten</translation>
    </message>
    <message>
        <source>With G41, G42 the program gives</source>
        <translation>Mit G41, G42 gibt das Programm an</translation>
    </message>
    <message>
        <source>Depth along</source>
        <translation>Tiefe entlang</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Übertragungsfunktion</translation>
    </message>
    <message>
        <source>Stock left on</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>Allowance kept</source>
        <translation>Aufmaß bleibt</translation>
    </message>
    <message>
        <source>Share that may be unmeasured</source>
        <translation>Anteil, der ungemessen sein darf</translation>
    </message>
    <message>
        <source>the cutter's centre</source>
        <translation>die Fräsermitte</translation>
    </message>
    <message>
        <source>Toolpath correction report</source>
        <translation>Bericht der Bahnkorrektur</translation>
    </message>
    <message>
        <source>{} to {}, {} in the mean</source>
        <translation>{} bis {}, im Mittel {}</translation>
    </message>
    <message>
        <source>1 move</source>
        <translation>1 Weg</translation>
    </message>
    <message>
        <source>{} moves</source>
        <translation>{} Wege</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>{} warnings</source>
        <translation>{} Warnungen</translation>
    </message>
    <message>
        <source>Deviations are signed along the nominal's normal: &lt;b&gt;positive is excess material, negative is undercut&lt;/b&gt;. Deviations in {}, coordinates and lengths in {}.</source>
        <translation>Abweichungen zählen entlang der Normalen des Sollprofils: &lt;b&gt;positiv ist stehendes Material, negativ ist Unterschnitt&lt;/b&gt;. Abweichungen in {}, Koordinaten und Längen in {}.</translation>
    </message>
    <message>
        <source>min</source>
        <translation>kleinste</translation>
    </message>
    <message>
        <source>max</source>
        <translation>größte</translation>
    </message>
    <message>
        <source>profile value</source>
        <translation>Profilwert</translation>
    </message>
    <message>
        <source>All by the model: the program as it came, and after the correction, each simulated.</source>
        <translation>Alles nach dem Modell: das Programm, wie es kam, und nach der Korrektur, beide simuliert.</translation>
    </message>
    <message>
        <source>The profile value is 2·max|d|, to be held against the width of a profile tolerance zone (ISO 1101).</source>
        <translation>Der Profilwert ist 2·max|d|, zu vergleichen mit der Breite einer Profiltoleranzzone (ISO 1101).</translation>
    </message>
    <message>
        <source>The next part brings its own random part: measured the same way, a standard deviation of about &lt;b&gt;{}&lt;/b&gt; is to be expected.</source>
        <translation>Das nächste Teil bringt seinen eigenen zufälligen Anteil mit: gleich gemessen ist eine Standardabweichung von etwa &lt;b&gt;{}&lt;/b&gt; zu erwarten.</translation>
    </message>
    <message>
        <source>predicted mean</source>
        <translation>Mittel, erwartet</translation>
    </message>
    <message>
        <source>Deviations on the contour</source>
        <translation>Abweichungen an der Kontur</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>measured / {}</source>
        <translation>gemessen / {}</translation>
    </message>
    <message>
        <source>expected / {}</source>
        <translation>erwartet / {}</translation>
    </message>
    <message>
        <source>The program's own path error</source>
        <translation>Eigener Bahnfehler des Programms</translation>
    </message>
    <message>
        <source>at the points</source>
        <translation>an den Punkten</translation>
    </message>
    <message>
        <source>the contour; the control offsets by the radius</source>
        <translation>die Kontur; die Steuerung versetzt um den Radius</translation>
    </message>
    <message>
        <source>given</source>
        <translation>angegeben</translation>
    </message>
    <message>
        <source>the contour that the program cuts</source>
        <translation>die Kontur, die das Programm fräst</translation>
    </message>
    <message>
        <source>{} measured points ({}) show deviations of {}.</source>
        <translation>{} gemessene Punkte ({}) zeigen Abweichungen von {}.</translation>
    </message>
    <message>
        <source>No measurement: the path is laid on the exact parallel of the nominal contour.</source>
        <translation>Keine Messung: die Bahn wird auf die genaue Parallele der Sollkontur gelegt.</translation>
    </message>
    <message>
        <source>Nothing is to be corrected: &lt;b&gt;the program stays as it is&lt;/b&gt;.</source>
        <translation>Nichts ist zu korrigieren: &lt;b&gt;das Programm bleibt, wie es ist&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>largest correction of the contour</source>
        <translation>größte Korrektur der Kontur</translation>
    </message>
    <message>
        <source>largest path error of the program, read back</source>
        <translation>größter Bahnfehler des Programms, zurückgelesen</translation>
    </message>
    <message>
        <source>No points were measured.</source>
        <translation>Es wurden keine Punkte gemessen.</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>determined part</source>
        <translation>bestimmter Anteil</translation>
    </message>
    <message>
        <source>predicted after</source>
        <translation>danach erwartet</translation>
    </message>
    <message>
        <source>Predicted: what the model expects at the same points, their random part unchanged.</source>
        <translation>Erwartet: was das Modell an denselben Punkten voraussagt, ihr zufälliger Anteil unverändert.</translation>
    </message>
    <message>
        <source>Predicted: the same points after the correction, this part's random part unchanged.</source>
        <translation>Erwartet: dieselben Punkte nach der Korrektur, der zufällige Anteil dieses Teils unverändert.</translation>
    </message>
    <message>
        <source>What repeats and what does not</source>
        <translation>Was sich wiederholt und was nicht</translation>
    </message>
    <message>
        <source>The correction in force</source>
        <translation>Die Korrektur, die schon wirkt</translation>
    </message>
    <message>
        <source>Uncertainty of the correction</source>
        <translation>Unsicherheit der Korrektur</translation>
    </message>
    <message>
        <source>Largest correction</source>
        <translation>Größte Korrektur</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Wege</translation>
    </message>
    <message>
        <source>{} of the program's moves changed, {} written</source>
        <translation>{} Wege des Programms geändert, {} geschrieben</translation>
    </message>
    <message>
        <source>Largest displacement of a vertex</source>
        <translation>Größte Verschiebung eines Eckpunkts</translation>
    </message>
    <message>
        <source>Largest path error</source>
        <translation>Größter Bahnfehler</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Profilverletzung</translation>
    </message>
    <message>
        <source>{} nearer to the profile than the cutter's radius at most</source>
        <translation>höchstens {} näher am Profil als der Fräserradius</translation>
    </message>
    <message>
        <source>Profile as NURBS</source>
        <translation>Profil als NURBS</translation>
    </message>
    <message>
        <source>within {} of the exact compensated contour</source>
        <translation>innerhalb {} der genauen korrigierten Kontur</translation>
    </message>
    <message>
        <source>Checked length of path</source>
        <translation>Geprüfte Bahnlänge</translation>
    </message>
    <message>
        <source>Tool diameter</source>
        <translation>Werkzeugdurchmesser</translation>
    </message>
    <message>
        <source>Program gives</source>
        <translation>Programm gibt an</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Sollkontur</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nothing was measured&lt;/b&gt;: the model of {} leaves {}.</source>
        <translation>&lt;b&gt;Nichts wurde gemessen&lt;/b&gt;: das Modell von {} lässt {}.</translation>
    </message>
    <message>
        <source>The model expects at most {} along the whole contour before the correction and {} after it.</source>
        <translation>Das Modell erwartet entlang der ganzen Kontur höchstens {} vor der Korrektur und {} danach.</translation>
    </message>
    <message>
        <source>&lt;b&gt;{} of the program change&lt;/b&gt; by the path's own error only.</source>
        <translation>Im Programm &lt;b&gt;geändert: {}&lt;/b&gt;, nur um den Fehler der Bahn selbst.</translation>
    </message>
    <message>
        <source>&lt;b&gt;The correction moves the contour by up to {}&lt;/b&gt; (at {}) and changes {}.</source>
        <translation>&lt;b&gt;Die Korrektur verschiebt die Kontur um bis zu {}&lt;/b&gt; (bei {}) und ändert {}.</translation>
    </message>
    <message>
        <source>mean deviation, {}, before and predicted</source>
        <translation>mittlere Abweichung, {}, vorher und erwartet</translation>
    </message>
    <message>
        <source>height (max − min), {}, before and predicted</source>
        <translation>Spanne (größte − kleinste), {}, vorher und erwartet</translation>
    </message>
    <message>
        <source>changed in the program</source>
        <translation>im Programm geändert</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Abweichungen</translation>
    </message>
    <message>
        <source>contour {}, Z {}</source>
        <translation>Kontur {}, Z {}</translation>
    </message>
    <message>
        <source>Outliers</source>
        <translation>Ausreißer</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>quadr. Mittel</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Korrektur</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Aligned by</source>
        <translation>Eingepasst um</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Eingaben</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Ausgaben</translation>
    </message>
    <message>
        <source>1 measured point ({}) shows deviations of {}.</source>
        <translation>1 gemessener Punkt ({}) zeigt Abweichungen von {}.</translation>
    </message>
    <message>
        <source>Deviation along the contour</source>
        <translation>Abweichung entlang der Kontur</translation>
    </message>
    <message>
        <source>Path and contour</source>
        <translation>Bahn und Kontur</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>on the profile</source>
        <translation>am Profil</translation>
    </message>
    <message>
        <source>deviation {} ({})</source>
        <translation>Abweichung {} ({})</translation>
    </message>
    <message>
        <source>of that determined {}, expected next {}</source>
        <translation>davon ermittelt {}, als Nächstes erwartet {}</translation>
    </message>
    <message>
        <source>left out: {}</source>
        <translation>ausgelassen: {}</translation>
    </message>
    <message>
        <source>{} as measured</source>
        <translation>{} wie gemessen</translation>
    </message>
    <message>
        <source>material left</source>
        <translation>Material steht</translation>
    </message>
    <message>
        <source>undercut</source>
        <translation>Unterschnitt</translation>
    </message>
    <message>
        <source>limits {:g} and {:g}: must be from -10 to 10 mm, the upper one above the lower</source>
        <translation>Grenzen {:g} und {:g}: müssen zwischen -10 und 10 mm liegen, die obere über der unteren</translation>
    </message>
    <message>
        <source>material left {}: must be {}</source>
        <translation>stehendes Material {}: muss {} sein</translation>
    </message>
    <message>
        <source>Predicted by the model</source>
        <translation>Vom Modell vorhergesagt</translation>
    </message>
    <message>
        <source>error expected / {}</source>
        <translation>erwarteter Fehler / {}</translation>
    </message>
    <message>
        <source>Force, engaged arc and feed</source>
        <translation>Kraft, Eingriffsbogen und Vorschub</translation>
    </message>
    <message>
        <source>Forces and deflections of the axes</source>
        <translation>Kräfte und Auslenkungen der Achsen</translation>
    </message>
    <message>
        <source>Contours and paths</source>
        <translation>Konturen und Bahnen</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Einrichtung</translation>
    </message>
    <message>
        <source>nothing is to be corrected, the program stays as it is</source>
        <translation>nichts ist zu korrigieren, das Programm bleibt, wie es ist</translation>
    </message>
    <message>
        <source>{}; {:.0f} % of the contour rests on no points</source>
        <translation>{}; {:.0f} % der Kontur beruhen auf keinen Punkten</translation>
    </message>
    <message>
        <source>use it</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>look at {}</source>
        <translation>Ansehen: {}</translation>
    </message>
    <message>
        <source>{} was accepted and is not resolved</source>
        <translation>{} wurde angenommen und ist nicht gelöst</translation>
    </message>
    <message>
        <source>{} of {} points are outliers, there the largest</source>
        <translation>{} von {} Punkten sind Ausreißer, dort der größte</translation>
    </message>
    <message>
        <source>only the path's own error changes</source>
        <translation>nur der eigene Fehler der Bahn ändert sich</translation>
    </message>
    <message>
        <source>use it, and measure the first part</source>
        <translation>Verwenden und das erste Teil messen</translation>
    </message>
    <message>
        <source>{}, by the model alone</source>
        <translation>{}, allein nach dem Modell</translation>
    </message>
    <message>
        <source>use it if what the warnings ask is answered</source>
        <translation>Verwenden, wenn geklärt ist, was die Warnungen fragen</translation>
    </message>
    <message>
        <source>measure again or average parts</source>
        <translation>Neu messen oder Teile mitteln</translation>
    </message>
    <message>
        <source>{} do not repeat, only {} do</source>
        <translation>{} wiederholen sich nicht, nur {} tun es</translation>
    </message>
    <message>
        <source>the cut moves up to {} into the material, most at {}</source>
        <translation>der Schnitt rückt um bis zu {} ins Material, am meisten bei {}</translation>
    </message>
    <message>
        <source>the cut moves up to {} away from the part, most at {}</source>
        <translation>der Schnitt rückt um bis zu {} vom Teil weg, am meisten bei {}</translation>
    </message>
    <message>
        <source>legal filters: none, mean:5, mean:1,2,3,2,1 (odd number of weights), gauss:MM, robust:MM, auto</source>
        <translation>zulässige Filter: none, mean:5, mean:1,2,3,2,1 (ungerade Zahl von Gewichten), gauss:MM, robust:MM, auto</translation>
    </message>
    <message>
        <source>{} gap(s) without points, the longest {} from s = {}: the deviation there is not known</source>
        <translation>{} Lücke(n) ohne Punkte, die längste {} ab s = {}: die Abweichung dort ist nicht bekannt</translation>
    </message>
    <message>
        <source>a single point: its deviation is taken as it is, the random part cannot be known</source>
        <translation>ein einziger Punkt: seine Abweichung gilt, wie sie ist, der zufällige Teil ist nicht zu erkennen</translation>
    </message>
    <message>
        <source>arc lengths and deviations must be equally long rows, not {}, {}</source>
        <translation>Bogenlängen und Abweichungen müssen gleich lange Reihen sein, nicht {}, {}</translation>
    </message>
    <message>
        <source>there are no deviations to filter</source>
        <translation>es gibt keine Abweichungen zu filtern</translation>
    </message>
    <message>
        <source>an arc length or a deviation is not a finite number</source>
        <translation>eine Bogenlänge oder Abweichung ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the length of the stretch must be above 0, not {:g}</source>
        <translation>die Länge der Strecke muss über 0 sein, nicht {:g}</translation>
    </message>
    <message>
        <source>the mask of {} is longer than the row of {} points: cut to {}</source>
        <translation>die Maske von {} ist länger als die Reihe von {} Punkten: auf {} gekürzt</translation>
    </message>
    <message>
        <source>the mask is not symmetric: it shifts the deviations along the profile</source>
        <translation>die Maske ist nicht symmetrisch: sie verschiebt die Abweichungen entlang des Profils</translation>
    </message>
    <message>
        <source>the points are unevenly spaced (up to {}, median {}) and the moving average counts points: prefer gauss:MM or auto</source>
        <translation>die Punkte stehen ungleichmäßig (bis {}, Median {}), und das gleitende Mittel zählt Punkte: besser gauss:MM oder auto</translation>
    </message>
    <message>
        <source>the mask sums to 0 at an end of the row: those points are left unfiltered</source>
        <translation>die Maske ergibt am Ende der Reihe 0: diese Punkte bleiben ungefiltert</translation>
    </message>
    <message>
        <source>the cutoff of {} is below twice the point spacing ({}): next to nothing is filtered</source>
        <translation>die Grenzwellenlänge von {} liegt unter dem doppelten Punktabstand ({}): fast nichts wird gefiltert</translation>
    </message>
    <message>
        <source>the robust regression did not settle within {} rounds</source>
        <translation>die robuste Regression kam in {} Durchgängen nicht zur Ruhe</translation>
    </message>
    <message>
        <source>points far off the line, which are outliers and left out: {}</source>
        <translation>Punkte weitab der Linie, die Ausreißer sind und ausgelassen werden: {}</translation>
    </message>
    <message>
        <source>unknown filter '{}'; {}</source>
        <translation>unbekannter Filter „{}“; {}</translation>
    </message>
    <message>
        <source>filter '{}' holds a number that is not finite; {}</source>
        <translation>Filter „{}“ enthält eine Zahl, die nicht endlich ist; {}</translation>
    </message>
    <message>
        <source>filter '{}' has an even number of weights; {}</source>
        <translation>Filter „{}“ hat eine gerade Zahl von Gewichten; {}</translation>
    </message>
    <message>
        <source>the weights of filter '{}' add up to 0; {}</source>
        <translation>die Gewichte des Filters „{}“ ergeben zusammen 0; {}</translation>
    </message>
    <message>
        <source>the points spread over {} of a stretch of {}</source>
        <translation>die Punkte erstrecken sich über {} einer Strecke von {}</translation>
    </message>
    <message>
        <source>the mask of {} is longer than the row of {} points</source>
        <translation>die Maske von {} ist länger als die Reihe von {} Punkten</translation>
    </message>
    <message>
        <source>filter '{}' holds something that is not a number; {}</source>
        <translation>Filter „{}“ enthält etwas, das keine Zahl ist; {}</translation>
    </message>
    <message>
        <source>filter '{}' needs one cutoff in mm above 0; {}</source>
        <translation>Filter „{}“ braucht eine Grenzwellenlänge in mm über 0; {}</translation>
    </message>
    <message>
        <source>filter '{}' needs an odd whole number of points; {}</source>
        <translation>Filter „{}“ braucht eine ungerade ganze Zahl von Punkten; {}</translation>
    </message>
    <message>
        <source>part {} was measured at other places than the first: nothing can be averaged</source>
        <translation>Teil {} wurde an anderen Stellen gemessen als das erste: nichts lässt sich mitteln</translation>
    </message>
    <message>
        <source>{}: the points lie {} off the profile and not {} over it: check {}; it belongs to a part with stock left on it, and {} is then the program that finishes it</source>
        <translation>{}: die Punkte liegen {} neben dem Profil und nicht {} darüber: prüfen Sie {}; es gehört zu einem Teil mit stehendem Aufmaß, und {} ist dann das Programm, das es fertigstellt</translation>
    </message>
    <message>
        <source>what is cut under {} is another part than the measured one, cut under {}: it stays as it is</source>
        <translation>was unter {} geschnitten wird, ist ein anderes Teil als das gemessene, geschnitten unter {}: es bleibt, wie es ist</translation>
    </message>
    <message>
        <source>the diameter of {} is not known</source>
        <translation>der Durchmesser von {} ist nicht bekannt</translation>
    </message>
    <message>
        <source>the tool diameter {} must be a length above 0</source>
        <translation>der Werkzeugdurchmesser {} muss eine Länge über 0 sein</translation>
    </message>
    <message>
        <source>the same measurement is given twice: averaging needs different parts</source>
        <translation>dieselbe Messung ist zweimal gegeben: Mitteln braucht verschiedene Teile</translation>
    </message>
    <message>
        <source>{} carries the correction from this measurement already, since {}: the part was cut by an earlier program, so all is shown as if this one carried no correction</source>
        <translation>{} trägt die Korrektur aus dieser Messung schon, seit {}: das Teil wurde mit einem früheren Programm geschnitten, darum steht alles so da, als trüge dieses keine Korrektur</translation>
    </message>
    <message>
        <source>{}:{}: a part with stock left was cut by a first cut of the uncorrected program: give that as {}, not one that was corrected since</source>
        <translation>{}:{}: ein Teil mit stehendem Aufmaß wurde mit einem ersten Schnitt des unkorrigierten Programms geschnitten: geben Sie dieses als {}, nicht eines, das seither korrigiert wurde</translation>
    </message>
    <message>
        <source>{} needs {}: one touch or two; without any {}</source>
        <translation>{} braucht {}: eine Berührung oder zwei; ohne jede {}</translation>
    </message>
    <message>
        <source>{} takes no {}: with touches use {}</source>
        <translation>{} nimmt kein {}: mit Berührungen {} verwenden</translation>
    </message>
    <message>
        <source>a first cut that leaves stock is made before anything is measured</source>
        <translation>ein erster Schnitt, der Aufmaß lässt, wird gemacht, bevor etwas gemessen ist</translation>
    </message>
    <message>
        <source>{}: no move runs along the contour that the points lie on</source>
        <translation>{}: keine Bewegung läuft entlang der Kontur, auf der die Punkte liegen</translation>
    </message>
    <message>
        <source>{}:{}: {} names a corrected program; give the first, uncorrected one</source>
        <translation>{}:{}: {} nennt ein korrigiertes Programm; geben Sie das erste, unkorrigierte</translation>
    </message>
    <message>
        <source>{} or {}: the program has no G41 or G42 that tells the side of the cutter</source>
        <translation>{} oder {}: das Programm hat kein G41 oder G42, das die Seite des Fräsers nennt</translation>
    </message>
    <message>
        <source>{} states it</source>
        <translation>{} nennt ihn</translation>
    </message>
    <message>
        <source>a T word before its cuts gives it a number to state</source>
        <translation>ein T-Wort vor seinen Schnitten gibt ihm eine Nummer, um ihn zu nennen</translation>
    </message>
    <message>
        <source>{}: what it cuts stays as it is and is not looked at; {}</source>
        <translation>{}: was es schneidet, bleibt, wie es ist, und wird nicht angesehen; {}</translation>
    </message>
    <message>
        <source>{}: the program has no feed move that could follow a contour</source>
        <translation>{}: das Programm hat keine Vorschubbewegung, die einer Kontur folgen könnte</translation>
    </message>
    <message>
        <source>nothing that runs along a contour is read: {}; write the moves in place of this line, as {}</source>
        <translation>nichts, was entlang einer Kontur läuft, ist lesbar: {}; schreiben Sie die Bewegungen statt dieser Zeile, als {}</translation>
    </message>
    <message>
        <source>{}: a cutter of {} takes no more than its width off; the depth is meant along the contour's normal, from the stock to the surface, in mm</source>
        <translation>{}: ein Fräser von {} nimmt nicht mehr als seine Breite ab; gemeint ist die Tiefe entlang der Normalen der Kontur, vom Rohteil zur Fläche, in mm</translation>
    </message>
    <message>
        <source>{} is a file; name a directory</source>
        <translation>{} ist eine Datei; nennen Sie ein Verzeichnis</translation>
    </message>
    <message>
        <source>{}: the report needs a directory, this is a file</source>
        <translation>{}: der Bericht braucht ein Verzeichnis, das ist eine Datei</translation>
    </message>
    <message>
        <source>{} is the {} itself; the original must stay untouched</source>
        <translation>{} ist selbst die Datei „{}“; das Original muss unberührt bleiben</translation>
    </message>
    <message>
        <source>{} is a directory; name the file to write</source>
        <translation>{} ist ein Verzeichnis; nennen Sie die zu schreibende Datei</translation>
    </message>
    <message>
        <source>{} would replace the {}, {}: name another directory</source>
        <translation>{} würde „{}“, {}, ersetzen: nennen Sie ein anderes Verzeichnis</translation>
    </message>
    <message>
        <source>{}: cannot be written: {}</source>
        <translation>{}: nicht schreibbar: {}</translation>
    </message>
</context>
</TS>
