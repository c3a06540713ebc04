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
        <source>Depth in mm along the normal that the measured part was cut at; one, or one a part</source>
        <translation>Tiefe in mm längs der Normalen, mit der das gemessene Teil gefräst wurde; eine, oder eine je Teil</translation>
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
        <source>Stock in mm that the path of the measured part left on the nominal</source>
        <translation>Aufmaß in mm, das die Bahn des gemessenen Teils auf der Sollkontur gelassen hat</translation>
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
        <source>Feed of the touch, mm/min</source>
        <translation>Vorschub der Antastung, mm/min</translation>
    </message>
    <message>
        <source>Feed of moves at measuring height, mm/min</source>
        <translation>Vorschub der Wege in Messhöhe, mm/min</translation>
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
        <source>Origin of the work frame in the file's, mm</source>
        <translation>Ursprung des Werkstücksystems in dem der Datei, mm</translation>
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
        <source>the file does not say</source>
        <translation>die Datei sagt es nicht</translation>
    </message>
    <message>
        <source>the work frame; the file does not say</source>
        <translation>das Werkstücksystem; die Datei sagt es nicht</translation>
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
        <source>no METRIC in the first line, which PC-DMIS takes for inch</source>
        <translation>kein METRIC in der ersten Zeile, was PC-DMIS als Zoll nimmt</translation>
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
        <source>{}: the measurement holds no file</source>
        <translation>{}: die Messung enthält keine Datei</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>keine solche Datei</translation>
    </message>
    <message>
        <source>cannot be read: {}</source>
        <translation>nicht lesbar: {}</translation>
    </message>
    <message>
        <source>{} is a measured part of {} already: switch it on instead</source>
        <translation>{} ist schon ein gemessenes Teil von {}: schalten Sie es stattdessen ein</translation>
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
        <source>in an inner corner or hollow that the cutter cannot reach</source>
        <translation>in einer Innenecke oder Höhlung, die der Fräser nicht erreicht</translation>
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
        <source>{} parts cut {} mm deep: the transfer function is taken from the difference, the constant offset apart; deviations are shown as at the depth of the first</source>
        <translation>{} Teile, {} mm tief geschnitten: die Übertragungsfunktion folgt aus dem Unterschied, der gleichbleibende Versatz getrennt; Abweichungen stehen wie bei der Tiefe des ersten</translation>
    </message>
    <message>
        <source>the parts were cut at different depths: say with {} what the next one takes off</source>
        <translation>die Teile wurden verschieden tief geschnitten: sagen Sie mit {}, was der nächste Schnitt abnimmt</translation>
    </message>
    <message>
        <source>{} stretches of contours without a measured point are left as they are</source>
        <translation>{} Strecken von Konturen ohne gemessenen Punkt bleiben, wie sie sind</translation>
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
        <source>{}: choose one of {}</source>
        <translation>{}: wählen Sie eines von {}</translation>
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
        <source>{} touches, {} of {} ways between them over the safe height</source>
        <translation>{} Berührungen, {} von {} Wegen dazwischen über die sichere Höhe</translation>
    </message>
    <message>
        <source>measured at {}, passed over at {}</source>
        <translation>gemessen auf {}, überfahren auf {}</translation>
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
        <source>left out</source>
        <translation>ausgelassen</translation>
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
        <source>{} of {} points are outliers, there the largest</source>
        <translation>{} von {} Punkten sind Ausreißer, dort der größte</translation>
    </message>
    <message>
        <source>only the path's own error changes</source>
        <translation>nur der eigene Fehler der Bahn ändert sich</translation>
    </message>
    <message>
        <source>the contour moves by up to {}, most at {}</source>
        <translation>die Kontur rückt um bis zu {}, am meisten bei {}</translation>
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
        <source>{} was accepted and is not resolved</source>
        <translation>{} wurde angenommen und ist nicht gelöst</translation>
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
        <source>legal filters: none, mean:5, mean:1,2,3,2,1 (odd number of weights), gauss:MM, robust:MM, auto</source>
        <translation>zulässige Filter: none, mean:5, mean:1,2,3,2,1 (ungerade Zahl von Gewichten), gauss:MM, robust:MM, auto</translation>
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
        <source>the diameter of {} is not known</source>
        <translation>der Durchmesser von {} ist nicht bekannt</translation>
    </message>
    <message>
        <source>what is cut under {} is another part than the measured one, cut under {}: it stays as it is</source>
        <translation>was unter {} geschnitten wird, ist ein anderes Teil als das gemessene, geschnitten unter {}: es bleibt, wie es ist</translation>
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
</context>
</TS>
