<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>BodyDragTool</name>
    <message>
        <source>Move %1</source>
        <translation>%1 bewegen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
</context>
<context>
    <name>ClosePrompt</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Änderungen an %1 speichern?</translation>
    </message>
    <message>
        <source>They will be lost if you do not save them.</source>
        <translation>Sie gehen verloren, wenn Sie nicht speichern.</translation>
    </message>
    <message>
        <source>Documents to save</source>
        <translation>Zu speichernde Dokumente</translation>
    </message>
    <message>
        <source>&amp;Save all</source>
        <translation>Alle &amp;speichern</translation>
    </message>
    <message>
        <source>&amp;Save the checked</source>
        <translation>Markierte &amp;speichern</translation>
    </message>
    <message>
        <source>&amp;Discard all</source>
        <translation>Alle &amp;verwerfen</translation>
    </message>
    <message numerus="yes">
        <source>Save the changes to %n document(s)?</source>
        <translation>
            <numerusform>Die Änderungen an %n Dokument speichern?</numerusform>
            <numerusform>Die Änderungen an %n Dokumenten speichern?</numerusform>
        </translation>
    </message>
    <message>
        <source>The changes to those that are not checked will be lost.</source>
        <translation>Die Änderungen an nicht markierten gehen verloren.</translation>
    </message>
</context>
<context>
    <name>DefectModel</name>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>Non-manifold edges</source>
        <translation>Nicht-mannigf. Kanten</translation>
    </message>
    <message>
        <source>Non-manifold vertices</source>
        <translation>Nicht-mannigf. Eckpunkte</translation>
    </message>
    <message>
        <source>One-sided edges</source>
        <translation>Kanten mit nur einer Seite</translation>
    </message>
    <message>
        <source>Inside out</source>
        <translation>Innenseite außen</translation>
    </message>
    <message>
        <source>Near vertices</source>
        <translation>Fast gleiche Eckpunkte</translation>
    </message>
    <message>
        <source>Reversed on opening</source>
        <translation>Beim Öffnen umgekehrt</translation>
    </message>
    <message>
        <source>Degenerate triangles</source>
        <translation>Entartete Dreiecke</translation>
    </message>
    <message>
        <source>Duplicate triangles</source>
        <translation>Doppelte Dreiecke</translation>
    </message>
    <message>
        <source>Self-intersections</source>
        <translation>Selbstdurchdringungen</translation>
    </message>
    <message>
        <source>Debris</source>
        <translation>Bruchstücke</translation>
    </message>
    <message>
        <source>Places where the surface is missing. (A tunnel through the part is not a hole.)</source>
        <translation>Stellen, an denen die Oberfläche fehlt. (Ein Tunnel durch das Teil ist kein Loch.)</translation>
    </message>
    <message>
        <source>Outer boundaries of open sheets, and holes that you marked to keep open. “Repair all” does not close them.</source>
        <translation>Außenränder offener Flächen und Löcher, die offen bleiben sollen. „Alles reparieren“ schließt sie nicht.</translation>
    </message>
    <message>
        <source>Edges at which more than two triangles meet.</source>
        <translation>Kanten, an denen sich mehr als zwei Dreiecke treffen.</translation>
    </message>
    <message>
        <source>Vertices at which parts of the surface touch without sharing an edge.</source>
        <translation>Eckpunkte, an denen sich Teile der Oberfläche ohne gemeinsame Kante berühren.</translation>
    </message>
    <message>
        <source>Edges at which inside becomes outside: like a Möbius strip, the surface has only one side.</source>
        <translation>Kanten, an denen innen zu außen wird: Wie ein Möbiusband hat die Oberfläche nur eine Seite.</translation>
    </message>
    <message>
        <source>Vertices on open edges that differ only by rounding in the file. A repair merges them.</source>
        <translation>Eckpunkte an offenen Kanten, die sich nur durch Rundung in der Datei unterscheiden. Eine Reparatur verschmilzt sie.</translation>
    </message>
    <message>
        <source>Bodies whose triangles face inwards, so that inside and outside are swapped.</source>
        <translation>Körper, deren Dreiecke nach innen zeigen, sodass innen und außen vertauscht sind.</translation>
    </message>
    <message>
        <source>Triangles without area.</source>
        <translation>Dreiecke ohne Flächeninhalt.</translation>
    </message>
    <message>
        <source>Triangles that lie exactly on another one.</source>
        <translation>Dreiecke, die genau auf einem anderen liegen.</translation>
    </message>
    <message>
        <source>Pieces apart from the largest one, with less than %1 % of its area and less than %2 % of its triangles. “Remove debris” removes all, or only the piece selected here; any other piece is removed with the tool “Select faces”.</source>
        <translation>Stücke neben dem größten, mit weniger als %1 % seiner Fläche und weniger als %2 % seiner Dreiecke. „Bruchstücke entfernen“ entfernt alle oder nur das hier gewählte Stück; andere Stücke entfernt das Werkzeug „Flächen auswählen“.</translation>
    </message>
    <message>
        <source>Boundaries kept open</source>
        <translation>Offen gelassene Ränder</translation>
    </message>
    <message>
        <source>Inconsistent triangles</source>
        <translation>Uneinheitliche Dreiecke</translation>
    </message>
    <message>
        <source>Triangles with an orientation opposite to that of their neighbours. Opening a file reverses them, as the first step of the history; they are listed here where that step is undone.</source>
        <translation>Dreiecke, die entgegengesetzt zu ihren Nachbarn orientiert sind. Beim Öffnen einer Datei werden sie umgekehrt, als erster Schritt des Verlaufs; hier stehen sie, wenn dieser Schritt rückgängig gemacht ist.</translation>
    </message>
    <message>
        <source>No longer a defect: triangles with an orientation opposite to that of their neighbours in the file were reversed on opening, as the first step of the history. If the neighbours were wrong, “Reverse faces” reverses the whole shell.</source>
        <translation>Kein Fehler mehr: Dreiecke, die in der Datei entgegengesetzt zu ihren Nachbarn orientiert waren, wurden beim Öffnen umgekehrt, als erster Schritt des Verlaufs. Waren die Nachbarn falsch, kehrt „Flächen umkehren“ die ganze Schale um.</translation>
    </message>
    <message>
        <source>Pairs of triangles that intersect. “Repair all” cuts them along each other and joins them so that none intersects another, where that leaves nothing else worse.</source>
        <translation>Paare von Dreiecken, die sich durchdringen. „Alles reparieren“ schneidet sie aneinander und verbindet sie so, dass keines ein anderes durchdringt, sofern dadurch nichts anderes schlechter wird.</translation>
    </message>
</context>
<context>
    <name>DeviceText</name>
    <message>
        <source>Not plugged in</source>
        <translation>Nicht angeschlossen</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Startet …</translation>
    </message>
    <message>
        <source>Needs homing</source>
        <translation>Muss seine Lage finden</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>No force: the device is not ready.</source>
        <translation>Keine Kraft: Das Gerät ist nicht bereit.</translation>
    </message>
    <message>
        <source>The force rises slowly after a change.</source>
        <translation>Die Kraft steigt nach einer Änderung langsam an.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>Largest torque</source>
        <translation>Größtes Drehmoment</translation>
    </message>
    <message>
        <source>Largest force of the grip</source>
        <translation>Größte Kraft des Griffs</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Stiffness in rotation</source>
        <translation>Drehsteifigkeit</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Radius of the workspace</source>
        <translation>Radius des Arbeitsraums</translation>
    </message>
    <message>
        <source>Servo rate</source>
        <translation>Servotakt</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>Softer than set: %1 of %2 N/mm; limit of the %3 at %4 kHz and %5 ms of delay</source>
        <translation>Weicher als eingestellt: %1 von %2 N/mm; Grenze für %3 bei %4 kHz und %5 ms Verzögerung</translation>
    </message>
    <message>
        <source>Its position is not calibrated yet. Pull the grip slowly all the way out, push it all the way in, and bring it back to the middle. There is no force until then.</source>
        <translation>Seine Position ist noch nicht kalibriert. Ziehen Sie den Griff langsam ganz heraus, schieben Sie ihn ganz hinein, und bringen Sie ihn zurück in die Mitte. Bis dahin gibt es keine Kraft.</translation>
    </message>
    <message>
        <source>Its position is not calibrated yet. Put the pen into its inkwell and hold it there for a moment; bring a device without an inkwell to its reset position. There is no force until then.</source>
        <translation>Seine Position ist noch nicht kalibriert. Stecken Sie den Stift in die Halterung, und halten Sie ihn dort einen Moment; ein Gerät ohne Halterung bringen Sie in seine Ruheposition. Bis dahin gibt es keine Kraft.</translation>
    </message>
    <message>
        <source>Its position is not calibrated yet. Calibrate it as described in its manual. There is no force until then.</source>
        <translation>Seine Position ist noch nicht kalibriert. Kalibrieren Sie es nach seiner Anleitung. Bis dahin gibt es keine Kraft.</translation>
    </message>
    <message>
        <source>Does not respond correctly</source>
        <translation>Antwortet nicht richtig</translation>
    </message>
    <message>
        <source>Connecting; the firmware may be loading. This can take some seconds.</source>
        <translation>Verbindung wird hergestellt; eventuell wird die Firmware geladen. Das kann einige Sekunden dauern.</translation>
    </message>
    <message>
        <source>No force: the requested force is not a number.</source>
        <translation>Keine Kraft: Die angeforderte Kraft ist keine Zahl.</translation>
    </message>
    <message>
        <source>Damped: the device returned more energy than was put in.</source>
        <translation>Gedämpft: Das Gerät gab mehr Energie ab, als zugeführt wurde.</translation>
    </message>
    <message>
        <source>Damped: it moves faster than a hand normally does.</source>
        <translation>Gedämpft: Es bewegt sich schneller, als eine Hand es normalerweise tut.</translation>
    </message>
    <message>
        <source>No force: it moves as if nobody were holding it.</source>
        <translation>Keine Kraft: Es bewegt sich, als hielte es niemand.</translation>
    </message>
    <message>
        <source>The force fades: no update arrived in time.</source>
        <translation>Die Kraft klingt ab: Es kam nicht rechtzeitig eine neue Vorgabe.</translation>
    </message>
    <message>
        <source>The rate of change of the force is limited.</source>
        <translation>Die Änderungsrate der Kraft ist begrenzt.</translation>
    </message>
    <message>
        <source>The force is at the limit of the device.</source>
        <translation>Die Kraft hat die Grenze des Geräts erreicht.</translation>
    </message>
    <message>
        <source>Softer than set: %1 of %2 N/mm; limit specified for the %3</source>
        <translation>Weicher als eingestellt: %1 von %2 N/mm; angegebene Grenze für %3</translation>
    </message>
    <message>
        <source>The system does not allow the servo loop to run in real time. Ticks are late when the computer is busy, and the stiffness is reduced to allow for that. To permit real time, run this line in a terminal, then log out and in again:</source>
        <translation>Das System lässt die Servoschleife nicht in Echtzeit laufen. Wenn der Rechner ausgelastet ist, kommen Takte zu spät; die Steifigkeit ist daher verringert. Um Echtzeit zu erlauben, führen Sie diese Zeile in einem Terminal aus, und melden Sie sich ab und wieder an:</translation>
    </message>
    <message>
        <source>Measured axes</source>
        <translation>Gemessene Achsen</translation>
    </message>
    <message>
        <source>Actuated axes</source>
        <translation>Angetriebene Achsen</translation>
    </message>
    <message>
        <source>Internal damping</source>
        <translation>Innere Dämpfung</translation>
    </message>
    <message>
        <source>Operating mode</source>
        <translation>Betriebsart</translation>
    </message>
    <message>
        <source>rate control: it springs back, its deflection sets the speed</source>
        <translation>Geschwindigkeitssteuerung: federt zurück, die Auslenkung gibt die Geschwindigkeit vor</translation>
    </message>
    <message>
        <source>Plug it in. If it is not opened automatically then, choose it again.</source>
        <translation>Schließen Sie es an. Wird es dann nicht von selbst geöffnet, wählen Sie es erneut.</translation>
    </message>
    <message>
        <source>Unplug it, wait for some seconds, and plug it in. If it is not opened automatically then, choose it again.</source>
        <translation>Ziehen Sie es ab, warten Sie einige Sekunden und schließen Sie es wieder an. Wird es dann nicht von selbst geöffnet, wählen Sie es erneut.</translation>
    </message>
</context>
<context>
    <name>DiscardedResult</name>
    <message>
        <source>“%1” has changed nothing</source>
        <translation>„%1“ hat nichts geändert</translation>
    </message>
    <message>
        <source>%1 was changed meanwhile, and the result was for its state before.</source>
        <translation>%1 wurde inzwischen geändert, und das Ergebnis galt für den Stand davor.</translation>
    </message>
    <message>
        <source>Start it again if it is still wanted.</source>
        <translation>Starten Sie es erneut, falls es noch gewünscht ist.</translation>
    </message>
</context>
<context>
    <name>DocumentKind</name>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Robot cell</source>
        <translation>Roboterzelle</translation>
    </message>
    <message>
        <source>Workpiece</source>
        <translation>Werkstück</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
</context>
<context>
    <name>ErrorText</name>
    <message>
        <source>the file ends too early (%1: %2 expected, %3 found)</source>
        <translation>die Datei endet zu früh (%1: %2 erwartet, %3 gefunden)</translation>
    </message>
    <message>
        <source>the file ends too early (%1: %3 found)</source>
        <translation>die Datei endet zu früh (%1: %3 gefunden)</translation>
    </message>
    <message>
        <source>the file is too large (more than %3 %1)</source>
        <translation>die Datei ist zu groß (mehr als %3 %1)</translation>
    </message>
    <message>
        <source>the file is too large (%2 %1, at most %3 can be opened)</source>
        <translation>die Datei ist zu groß (%2 %1, höchstens %3 können geöffnet werden)</translation>
    </message>
    <message>
        <source>%1 was expected, but nothing follows</source>
        <translation>%1 wurde erwartet, aber es folgt nichts mehr</translation>
    </message>
    <message>
        <source>%1 was expected, &apos;%2&apos; was found</source>
        <translation>%1 wurde erwartet, „%2“ gefunden</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>der Arbeitsspeicher reicht nicht aus</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>the file cannot be read (%1)</source>
        <translation>die Datei kann nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the header is malformed: %1 is missing</source>
        <translation>der Dateikopf ist fehlerhaft: %1 fehlt</translation>
    </message>
    <message>
        <source>the text is in %1, which cannot be read</source>
        <translation>der Text ist in %1 kodiert, was nicht gelesen werden kann</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>the coordinate &apos;%1&apos; is not a finite number</source>
        <translation>die Koordinate „%1“ ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>a face uses vertex %1, but the file has %2 vertices</source>
        <translation>eine Fläche verwendet Eckpunkt %1, die Datei hat aber nur %2 Eckpunkte</translation>
    </message>
    <message>
        <source>a face uses vertex %1, which could not be read</source>
        <translation>eine Fläche verwendet Eckpunkt %1, der nicht gelesen werden konnte</translation>
    </message>
    <message>
        <source>a face has fewer than three corners (%1)</source>
        <translation>eine Fläche hat weniger als drei Ecken (%1)</translation>
    </message>
    <message>
        <source>the data type &apos;%1&apos; is not known</source>
        <translation>der Datentyp „%1“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>the file is damaged here, and none of its triangles can be read</source>
        <translation>die Datei ist hier beschädigt, und keines ihrer Dreiecke ist lesbar</translation>
    </message>
    <message>
        <source>the file could not be written (%1)</source>
        <translation>die Datei konnte nicht geschrieben werden (%1)</translation>
    </message>
    <message>
        <source>the archive cannot be read (%1)</source>
        <translation>das Archiv kann nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>the part &apos;%1&apos; is missing</source>
        <translation>der Teil „%1“ fehlt</translation>
    </message>
    <message>
        <source>the part &apos;%1&apos; is damaged</source>
        <translation>der Teil „%1“ ist beschädigt</translation>
    </message>
    <message>
        <source>the file has version %1 of the format; this program knows up to version %2</source>
        <translation>die Datei hat Formatversion %1; dieses Programm kennt Versionen bis %2</translation>
    </message>
    <message>
        <source>the element &apos;%1&apos; is malformed: %2</source>
        <translation>das Element „%1“ ist fehlerhaft: %2</translation>
    </message>
    <message>
        <source>%1 cannot be %2; it must lie between %3 and %4</source>
        <translation>%1 kann nicht %2 sein; erlaubt ist %3 bis %4</translation>
    </message>
    <message>
        <source>%1 is not supported</source>
        <translation>%1 wird nicht unterstützt</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>Byte %1</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>Close other documents or programs, or try a model with fewer triangles.</source>
        <translation>Schließen Sie andere Dokumente oder Programme, oder nehmen Sie ein Modell mit weniger Dreiecken.</translation>
    </message>
    <message>
        <source>Export or copy the file again.</source>
        <translation>Exportieren oder kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>Reduce or split the model in the program that made it.</source>
        <translation>Verkleinern oder teilen Sie das Modell in dem Programm, das es erzeugt hat.</translation>
    </message>
    <message>
        <source>Save the file as UTF-8 text or in a binary format.</source>
        <translation>Speichern Sie die Datei als UTF-8-Text oder in einem Binärformat.</translation>
    </message>
    <message>
        <source>Export the file again; its beginning is damaged or of a variant that is not supported.</source>
        <translation>Exportieren Sie die Datei noch einmal; ihr Anfang ist beschädigt oder von einer nicht unterstützten Variante.</translation>
    </message>
    <message>
        <source>Export or copy the file again, or open only what is readable (on the command line: --partial).</source>
        <translation>Exportieren oder kopieren Sie die Datei noch einmal, oder öffnen Sie nur, was lesbar ist (auf der Befehlszeile: --partial).</translation>
    </message>
    <message>
        <source>Check the shape of that face, or export the model as triangles.</source>
        <translation>Prüfen Sie die Form dieser Fläche, oder exportieren Sie das Modell als Dreiecke.</translation>
    </message>
    <message>
        <source>Export the model as a surface of triangles; points and curves alone cannot be repaired.</source>
        <translation>Exportieren Sie das Modell als Dreiecksfläche; Punkte und Kurven allein lassen sich nicht reparieren.</translation>
    </message>
    <message>
        <source>Copy the file again, or go back to an earlier copy of it.</source>
        <translation>Kopieren Sie die Datei noch einmal, oder nehmen Sie eine frühere Kopie.</translation>
    </message>
    <message>
        <source>Open it with a newer version of Handwheel.</source>
        <translation>Öffnen Sie sie mit einer neueren Version von Handwheel.</translation>
    </message>
    <message>
        <source>Enter a value within these limits.</source>
        <translation>Geben Sie einen Wert innerhalb dieser Grenzen ein.</translation>
    </message>
    <message>
        <source>Export the model in another way or another format.</source>
        <translation>Exportieren Sie das Modell auf andere Weise oder in einem anderen Format.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>the plugin was made for another version of Handwheel (%1, here %2)</source>
        <translation>das Plugin wurde für eine andere Version von Handwheel gemacht (%1, hier %2)</translation>
    </message>
    <message>
        <source>the plugin cannot be used (%1)</source>
        <translation>das Plugin kann nicht benutzt werden (%1)</translation>
    </message>
    <message>
        <source>the device cannot be reached (%1)</source>
        <translation>das Gerät ist nicht erreichbar (%1)</translation>
    </message>
    <message>
        <source>Install a plugin that was made for this version, or remove the file.</source>
        <translation>Installieren Sie ein Plugin für diese Version, oder entfernen Sie die Datei.</translation>
    </message>
    <message>
        <source>Switch it off and on again, or try another port.</source>
        <translation>Schalten Sie es aus und wieder ein, oder versuchen Sie einen anderen Anschluss.</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>Choose another file.</source>
        <translation>Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Handwheel reads files that end in %1.</source>
        <translation>Handwheel liest Dateien mit der Endung %1.</translation>
    </message>
    <message>
        <source>Use a name that ends in %2.</source>
        <translation>Nehmen Sie einen Namen mit der Endung %2.</translation>
    </message>
    <message>
        <source>the step cannot be done: %1</source>
        <translation>der Schritt lässt sich nicht ausführen: %1</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Put the folder &apos;%2&apos; into &apos;%3&apos; or a folder above it, and open the file again.</source>
        <translation>Legen Sie den Ordner „%2“ in „%3“ oder einen Ordner darüber, und öffnen Sie die Datei erneut.</translation>
    </message>
    <message>
        <source>another program has changed the file since it was opened</source>
        <translation>ein anderes Programm hat die Datei seit dem Öffnen geändert</translation>
    </message>
    <message>
        <source>the document has no body &apos;%1&apos;</source>
        <translation>das Dokument hat keinen Körper „%1“</translation>
    </message>
    <message>
        <source>the body &apos;%1&apos; is not linked to a file</source>
        <translation>der Körper „%1“ ist mit keiner Datei verknüpft</translation>
    </message>
    <message>
        <source>Only a linked body can be read again; add the file as a new one.</source>
        <translation>Nur ein verknüpfter Körper kann neu eingelesen werden; fügen Sie die Datei als neuen hinzu.</translation>
    </message>
    <message>
        <source>the linked file %1 is missing</source>
        <translation>die verknüpfte Datei %1 fehlt</translation>
    </message>
    <message>
        <source>Put it back, or add the file from where it is now.</source>
        <translation>Legen Sie sie zurück, oder fügen Sie die Datei von ihrem jetzigen Ort hinzu.</translation>
    </message>
    <message>
        <source>Remove bodies, or add several as one file.</source>
        <translation>Entfernen Sie Körper, oder fügen Sie mehrere als eine Datei hinzu.</translation>
    </message>
    <message>
        <source>Reduce the mesh before adding it (&apos;handwheel decimate&apos;).</source>
        <translation>Verkleinern Sie das Netz vor dem Hinzufügen („handwheel decimate“).</translation>
    </message>
    <message>
        <source>the bar was cut already, so its size cannot change</source>
        <translation>die Stange wurde schon bearbeitet, ihre Größe steht daher fest</translation>
    </message>
    <message>
        <source>Undo the passes to change the size, or begin with a new workpiece.</source>
        <translation>Machen Sie die Schnitte rückgängig, um die Größe zu ändern, oder beginnen Sie mit einem neuen Werkstück.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is the name of body %2, and the number of another</source>
        <translation>„%1“ ist der Name von Körper %2 und die Nummer eines anderen</translation>
    </message>
    <message>
        <source>Give the name of the other body, or rename body %2.</source>
        <translation>Geben Sie den Namen des anderen Körpers an, oder benennen Sie Körper %2 um.</translation>
    </message>
    <message>
        <source>Choose a file that you have permission to read, and check that its disk is connected.</source>
        <translation>Wählen Sie eine Datei, die Sie lesen dürfen, und prüfen Sie, ob ihr Laufwerk verbunden ist.</translation>
    </message>
    <message>
        <source>Check the free space and your write permission, or choose another location.</source>
        <translation>Prüfen Sie den freien Platz und Ihre Schreibrechte, oder wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>the file is inconsistent (%1: %2 expected, %3 found)</source>
        <translation>die Datei ist widersprüchlich (%1: %2 erwartet, %3 gefunden)</translation>
    </message>
    <message>
        <source>Correct the file at this position, or export it again.</source>
        <translation>Berichtigen Sie die Datei an dieser Stelle, oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 &apos;%2&apos; was not found in the folder &apos;%3&apos; or in those above it</source>
        <translation>%1 „%2“ wurde weder im Ordner „%3“ noch in den Ordnern darüber gefunden</translation>
    </message>
    <message>
        <source>%1 &apos;%2&apos; is referenced, but cannot be found</source>
        <translation>auf %1 „%2“ wird verwiesen, aber es ist nicht zu finden</translation>
    </message>
    <message>
        <source>Put the missing file where it is expected.</source>
        <translation>Legen Sie die fehlende Datei dorthin, wo sie erwartet wird.</translation>
    </message>
    <message>
        <source>the library %1 failed (%2)</source>
        <translation>die Bibliothek %1 ist gescheitert (%2)</translation>
    </message>
    <message>
        <source>this is not a file that Handwheel can read</source>
        <translation>diese Datei kann Handwheel nicht lesen</translation>
    </message>
    <message>
        <source>the extension &apos;%1&apos; is not a format that this can be written in</source>
        <translation>die Endung „%1“ bezeichnet kein Format, in dem dies geschrieben werden kann</translation>
    </message>
    <message>
        <source>the file name has no extension to specify the format</source>
        <translation>der Dateiname hat keine Endung, die das Format angibt</translation>
    </message>
    <message>
        <source>Save under another name to keep both, or replace the version of the other program.</source>
        <translation>Speichern Sie unter einem anderen Namen, um beides zu behalten, oder ersetzen Sie die Fassung des anderen Programms.</translation>
    </message>
    <message>
        <source>a body of the document is linked to this file, which would be overwritten</source>
        <translation>ein Körper des Dokuments ist mit dieser Datei verknüpft, die überschrieben würde</translation>
    </message>
    <message>
        <source>Write to another file, or unlink the body first.</source>
        <translation>Schreiben Sie in eine andere Datei, oder lösen Sie zuerst die Verknüpfung des Körpers.</translation>
    </message>
    <message>
        <source>the written file did not pass verification (%1), so it was discarded</source>
        <translation>die geschriebene Datei hat die Prüfung nicht bestanden (%1) und wurde daher verworfen</translation>
    </message>
    <message>
        <source>An existing file of that name was not changed. Save in another format, for example PLY.</source>
        <translation>Eine vorhandene Datei dieses Namens wurde nicht verändert. Speichern Sie in einem anderen Format, zum Beispiel PLY.</translation>
    </message>
    <message>
        <source>&apos;%2&apos; is not valid here</source>
        <translation>„%2“ ist hier nicht gültig</translation>
    </message>
    <message>
        <source>a face with %1 corners was triangulated as if it were convex</source>
        <translation>eine Fläche mit %1 Ecken wurde in Dreiecke zerlegt, als wäre sie konvex</translation>
    </message>
    <message>
        <source>Give the name or number of an existing body; &apos;inspect&apos; lists them.</source>
        <translation>Geben Sie Name oder Nummer eines vorhandenen an; „inspect“ listet sie auf.</translation>
    </message>
    <message>
        <source>a document can contain at most %1 bodies</source>
        <translation>ein Dokument fasst höchstens %1 Körper</translation>
    </message>
    <message>
        <source>the bodies would have %1 triangles, and a document can contain %2</source>
        <translation>die Körper hätten %1 Dreiecke, und ein Dokument fasst %2</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; is already in use</source>
        <translation>der Name „%1“ ist schon vergeben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a valid name: a name is one line of 1 to %2 bytes</source>
        <translation>„%1“ ist kein gültiger Name: Ein Name ist eine Zeile von 1 bis %2 Bytes</translation>
    </message>
    <message>
        <source>Check that it is plugged in, that no other program uses it and that you have permission to use it.</source>
        <translation>Prüfen Sie, ob es angeschlossen ist, kein anderes Programm es verwendet und Sie die Berechtigung dafür haben.</translation>
    </message>
    <message>
        <source>the device does not respond correctly (%1)</source>
        <translation>das Gerät antwortet nicht richtig (%1)</translation>
    </message>
    <message>
        <source>the file contains no triangles</source>
        <translation>die Datei enthält kein Dreieck</translation>
    </message>
    <message>
        <source>&apos;handwheel help edit&apos; lists the steps; loops are numbered as in &apos;handwheel inspect&apos;.</source>
        <translation>„handwheel help edit“ führt die Schritte auf; Randschleifen sind nummeriert wie von „handwheel inspect“.</translation>
    </message>
    <message>
        <source>Check the name, and whether the file was moved.</source>
        <translation>Prüfen Sie den Namen und ob die Datei verschoben wurde.</translation>
    </message>
    <message>
        <source>the file contains a &apos;%1&apos;, a kind of document that this program does not know</source>
        <translation>die Datei enthält „%1“, eine Dokumentart, die dieses Programm nicht kennt</translation>
    </message>
    <message>
        <source>the exercise is about “%1”, which this program cannot mark</source>
        <translation>die Übung handelt von „%1“, was dieses Programm nicht bewerten kann</translation>
    </message>
    <message>
        <source>Open it with a newer version of the program.</source>
        <translation>Öffnen Sie sie mit einer neueren Version des Programms.</translation>
    </message>
    <message>
        <source>it was handed in for another exercise, “%1”</source>
        <translation>sie wurde für eine andere Übung abgegeben, „%1“</translation>
    </message>
    <message>
        <source>Mark it with the exercise that the student&apos;s file was made from.</source>
        <translation>Bewerten Sie sie mit der Übung, aus der die Datei des Schülers entstanden ist.</translation>
    </message>
    <message>
        <source>the work does not belong to this exercise: %1</source>
        <translation>die Arbeit gehört nicht zu dieser Übung: %1</translation>
    </message>
    <message>
        <source>Begin the exercise from its file, and hand in that work.</source>
        <translation>Beginnen Sie die Übung aus ihrer Datei, und geben Sie diese Arbeit ab.</translation>
    </message>
    <message>
        <source>it has no work that was handed in</source>
        <translation>sie enthält keine abgegebene Arbeit</translation>
    </message>
    <message>
        <source>Ask the student to hand in the exercise once more.</source>
        <translation>Bitten Sie den Schüler, die Übung noch einmal abzugeben.</translation>
    </message>
    <message>
        <source>it is a student&apos;s copy, which has no marking scheme</source>
        <translation>es ist eine Schülerfassung, und die hat kein Bewertungsschema</translation>
    </message>
    <message>
        <source>Give the teacher&apos;s file of the exercise.</source>
        <translation>Geben Sie die Lehrerdatei der Übung an.</translation>
    </message>
    <message>
        <source>a student&apos;s copy of an exercise cannot be changed</source>
        <translation>die Schülerfassung einer Übung lässt sich nicht ändern</translation>
    </message>
    <message>
        <source>Change the teacher&apos;s file and make students&apos; copies of it again.</source>
        <translation>Ändern Sie die Lehrerdatei, und erzeugen Sie die Schülerfassungen daraus neu.</translation>
    </message>
    <message>
        <source>the part has %1 closed hollows, which the file cannot contain</source>
        <translation>das Teil hat %1 geschlossene Hohlräume, die die Datei nicht enthalten kann</translation>
    </message>
    <message>
        <source>Bore the part open from an end, or export triangles, for example STL.</source>
        <translation>Bohren Sie das Teil von einem Ende her auf, oder exportieren Sie Dreiecke, zum Beispiel STL.</translation>
    </message>
    <message>
        <source>the table has no column for the %1</source>
        <translation>der Tabelle fehlt eine Spalte für %1</translation>
    </message>
    <message>
        <source>Its first line has to name the columns; this one may be called %2.</source>
        <translation>Ihre erste Zeile muss die Spalten benennen; diese darf %2 heißen.</translation>
    </message>
    <message>
        <source>the table has two columns for the %1</source>
        <translation>die Tabelle hat zwei Spalten für %1</translation>
    </message>
    <message>
        <source>Remove one of them.</source>
        <translation>Entfernen Sie eine davon.</translation>
    </message>
    <message>
        <source>the table gives the spindle speed only, and no cutting speed</source>
        <translation>die Tabelle gibt nur die Drehzahl an und keine Schnittgeschwindigkeit</translation>
    </message>
    <message>
        <source>Say the diameter of the work (on the command line: --diameter), or add a column v in m/min.</source>
        <translation>Geben Sie den Durchmesser des Werkstücks an (auf der Befehlszeile: --diameter), oder fügen Sie eine Spalte v in m/min hinzu.</translation>
    </message>
    <message>
        <source>there are %1 different cuts, and a model needs at least %2</source>
        <translation>es sind %1 verschiedene Schnitte, und ein Modell braucht mindestens %2</translation>
    </message>
    <message>
        <source>Add measurements at other depths, feeds and speeds, made with a sharp tool.</source>
        <translation>Fügen Sie Messungen mit anderen Schnitttiefen, Vorschüben und Schnittgeschwindigkeiten hinzu, aufgenommen mit einem scharfen Werkzeug.</translation>
    </message>
    <message>
        <source>there is no work material &apos;%1&apos;</source>
        <translation>es gibt keinen Werkstoff „%1“</translation>
    </message>
    <message>
        <source>See the list of materials (on the command line: handwheel force --list).</source>
        <translation>Sehen Sie in der Liste der Werkstoffe nach (auf der Befehlszeile: handwheel force --list).</translation>
    </message>
    <message>
        <source>column %1, %2: %3</source>
        <translation>Spalte %1, %2: %3</translation>
    </message>
    <message>
        <source>%4 Then run the program again.</source>
        <translation>%4 Führen Sie das Programm dann erneut aus.</translation>
    </message>
    <message>
        <source>the program did not end after %1 blocks</source>
        <translation>das Programm war nach %1 Sätzen nicht zu Ende</translation>
    </message>
    <message>
        <source>Look for a loop whose condition never becomes false.</source>
        <translation>Suchen Sie nach einer Schleife, deren Bedingung nie falsch wird.</translation>
    </message>
    <message>
        <source>the program stops with the alarm %1: %2</source>
        <translation>das Programm hält mit dem Alarm %1 an: %2</translation>
    </message>
    <message>
        <source>the program stops with the alarm %1</source>
        <translation>das Programm hält mit dem Alarm %1 an</translation>
    </message>
    <message>
        <source>A control stops here, too, before the next move. Look at the condition of the alarm.</source>
        <translation>Auch eine Steuerung hält hier an, vor der nächsten Bewegung. Sehen Sie sich die Bedingung des Alarms an.</translation>
    </message>
    <message>
        <source>the tool path has more than %1 moves</source>
        <translation>der Werkzeugweg hat mehr als %1 Bewegungen</translation>
    </message>
    <message>
        <source>Take a larger depth of cut, or divide the program.</source>
        <translation>Nehmen Sie eine größere Schnitttiefe, oder teilen Sie das Programm.</translation>
    </message>
    <message>
        <source>the profile crosses the axis at Z %1 mm</source>
        <translation>das Profil kreuzt die Achse bei Z %1 mm</translation>
    </message>
    <message>
        <source>Draw only the half of the section on one side of the axis.</source>
        <translation>Zeichnen Sie nur die Hälfte des Schnitts auf einer Seite der Achse.</translation>
    </message>
    <message>
        <source>the profile touches the axis at Z %1 mm, so the part would be in pieces</source>
        <translation>das Profil berührt die Achse bei Z %1 mm, das Teil zerfiele also in Stücke</translation>
    </message>
    <message>
        <source>Import each piece from a file of its own.</source>
        <translation>Importieren Sie jedes Stück aus einer eigenen Datei.</translation>
    </message>
    <message>
        <source>the profile crosses or touches itself at radius %1 mm, Z %2 mm</source>
        <translation>das Profil kreuzt oder berührt sich selbst bei Radius %1 mm, Z %2 mm</translation>
    </message>
    <message>
        <source>Correct the outline there: it must enclose one area.</source>
        <translation>Berichtigen Sie dort den Umriss: Er muss eine einzige Fläche einschließen.</translation>
    </message>
    <message>
        <source>the profile has a gap of %1 mm at radius %2 mm, Z %3 mm</source>
        <translation>das Profil hat eine Lücke von %1 mm bei Radius %2 mm, Z %3 mm</translation>
    </message>
    <message>
        <source>Join the ends of the lines there.</source>
        <translation>Verbinden Sie dort die Enden der Linien.</translation>
    </message>
    <message>
        <source>the profile encloses no material</source>
        <translation>das Profil schließt kein Material ein</translation>
    </message>
    <message>
        <source>Draw the outline of the half section, from one end of the part to the other.</source>
        <translation>Zeichnen Sie den Umriss des Halbschnitts von einem Ende des Teils zum anderen.</translation>
    </message>
    <message>
        <source>the file contains no profile</source>
        <translation>die Datei enthält kein Profil</translation>
    </message>
    <message>
        <source>Draw the half section with visible lines, arcs or polylines, outside of blocks.</source>
        <translation>Zeichnen Sie den Halbschnitt mit sichtbaren Linien, Bögen oder Polylinien, außerhalb von Blöcken.</translation>
    </message>
    <message>
        <source>Remove frames, dimensions and other views, or join the ends of the lines.</source>
        <translation>Entfernen Sie Rahmen, Maße und andere Ansichten, oder verbinden Sie die Enden der Linien.</translation>
    </message>
    <message>
        <source>it is a binary DXF file, and only those in text can be read</source>
        <translation>es ist eine binäre DXF-Datei, und nur solche in Textform sind lesbar</translation>
    </message>
    <message>
        <source>Save it as ASCII DXF.</source>
        <translation>Speichern Sie sie als ASCII-DXF.</translation>
    </message>
    <message>
        <source>the drawing does not show where the axis is</source>
        <translation>die Zeichnung zeigt nicht, wo die Achse liegt</translation>
    </message>
    <message>
        <source>Draw the axis as a horizontal line with the id or layer &apos;axis&apos;.</source>
        <translation>Zeichnen Sie die Achse als waagerechte Linie mit der ID oder dem Layer „axis“.</translation>
    </message>
    <message>
        <source>the solid has no axis of revolution</source>
        <translation>der Volumenkörper hat keine Drehachse</translation>
    </message>
    <message>
        <source>Choose a part that can be turned.</source>
        <translation>Wählen Sie ein Teil, das sich drehen lässt.</translation>
    </message>
    <message>
        <source>it is not a turned part: face %1, a %2 at (%3, %4, %5), does not turn about its axis</source>
        <translation>es ist kein Drehteil: Fläche %1 (%2) bei (%3, %4, %5) ist nicht rotationssymmetrisch zu seiner Achse</translation>
    </message>
    <message>
        <source>Remove that feature, or choose to ignore what is not turned.</source>
        <translation>Entfernen Sie dieses Merkmal, oder lassen Sie außer Acht, was nicht gedreht ist.</translation>
    </message>
    <message>
        <source>Save the turned part alone in a file.</source>
        <translation>Speichern Sie das Drehteil allein in einer Datei.</translation>
    </message>
    <message>
        <source>nothing was cut yet, so there are no passes to write</source>
        <translation>es wurde noch nichts gedreht, daher gibt es keine Schnitte zu schreiben</translation>
    </message>
    <message>
        <source>Cut the part by hand first, or make cycles for a target.</source>
        <translation>Drehen Sie das Teil zuerst von Hand, oder erzeugen Sie Zyklen für ein Ziel.</translation>
    </message>
    <message>
        <source>the cycles collide in line %1</source>
        <translation>die Zyklen kollidieren in Zeile %1</translation>
    </message>
    <message>
        <source>Take a smaller nose or depth of cut.</source>
        <translation>Nehmen Sie einen kleineren Eckenradius oder eine kleinere Schnitttiefe.</translation>
    </message>
    <message>
        <source>the cycles cut %1 mm into the target at Z %2</source>
        <translation>die Zyklen schneiden bei Z %2 um %1 mm in das Ziel</translation>
    </message>
    <message>
        <source>Take a smaller nose.</source>
        <translation>Nehmen Sie einen kleineren Eckenradius.</translation>
    </message>
    <message>
        <source>Draw it with fewer lines, for example without hatching.</source>
        <translation>Zeichnen Sie ihn mit weniger Linien, zum Beispiel ohne Schraffur.</translation>
    </message>
    <message>
        <source>it is not a turned part: points are %1 mm off circles about an axis, %2 mm is allowed</source>
        <translation>es ist kein Drehteil: Punkte liegen %1 mm neben Kreisen um eine Achse, %2 mm sind erlaubt</translation>
    </message>
    <message>
        <source>Export the part as STEP, or as a finer mesh without other features.</source>
        <translation>Exportieren Sie das Teil als STEP oder als feineres Netz ohne andere Elemente.</translation>
    </message>
    <message>
        <source>the exercise has no target, so there is nothing to draw</source>
        <translation>Die Übung hat kein Ziel, also gibt es nichts zu zeichnen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither a path of the cell nor a file</source>
        <translation>„%1“ ist weder eine Bahn der Zelle noch eine Datei</translation>
    </message>
    <message>
        <source>Name a path of the cell (&apos;inspect&apos; lists them), or a file with one.</source>
        <translation>Nennen Sie eine Bahn der Zelle („inspect“ zeigt sie), oder eine Datei mit einer.</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; has fewer than two places</source>
        <translation>die Bahn „%1“ hat weniger als zwei Punkte</translation>
    </message>
    <message>
        <source>Add the places that the robot is to move to.</source>
        <translation>Fügen Sie die Punkte hinzu, die der Roboter anfahren soll.</translation>
    </message>
    <message>
        <source>at %1 the robot collides: %2 with %3</source>
        <translation>bei %1 stößt der Roboter an: %2 mit %3</translation>
    </message>
    <message>
        <source>at %1 the joint %2 is beyond its limits</source>
        <translation>bei %1 ist das Gelenk %2 außerhalb seiner Grenzen</translation>
    </message>
    <message>
        <source>Give joint values within the limits.</source>
        <translation>Geben Sie Gelenkwerte innerhalb der Grenzen an.</translation>
    </message>
    <message>
        <source>no path from %1 to %2 was found in %3 s</source>
        <translation>von %1 nach %2 wurde in %3 s keine Bahn gefunden</translation>
    </message>
    <message>
        <source>Allow more time, or insert a critical configuration in between.</source>
        <translation>Lassen Sie mehr Zeit, oder fügen Sie eine kritische Stellung dazwischen ein.</translation>
    </message>
    <message>
        <source>at %1 a joint beside the arm, such as a finger, has another value</source>
        <translation>bei %1 hat ein Gelenk neben dem Arm, etwa ein Finger, einen anderen Wert</translation>
    </message>
    <message>
        <source>Only the joints between base and tool are planned; the others must stay.</source>
        <translation>Nur die Gelenke zwischen Fuß und Werkzeug werden geplant; die anderen müssen bleiben.</translation>
    </message>
    <message>
        <source>the arm cannot follow the straight line to %1: it stops after %2 %</source>
        <translation>der Arm kann der geraden Linie nach %1 nicht folgen: er hält nach %2 % an</translation>
    </message>
    <message>
        <source>the robot cannot reach where motion %1 ends</source>
        <translation>der Roboter kann das Ende der Bewegung %1 nicht erreichen</translation>
    </message>
    <message>
        <source>Check that the program is for this robot, its tool and its frame.</source>
        <translation>Prüfen Sie, ob das Programm zu diesem Roboter, seinem Werkzeug und seinem Koordinatensystem gehört.</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; collides in %2 places, first %3 with %4</source>
        <translation>die Bahn „%1“ stößt an %2 Stellen an, zuerst %3 mit %4</translation>
    </message>
    <message>
        <source>Plan it again, or see all of them with &apos;verify&apos;.</source>
        <translation>Planen Sie sie neu, oder sehen Sie alle mit „verify“ an.</translation>
    </message>
    <message>
        <source>%1 programs move %2 joints, and this arm has %3</source>
        <translation>Programme in %1 bewegen %2 Gelenke, dieser Arm hat %3</translation>
    </message>
    <message>
        <source>Write the path as CSV or JSON.</source>
        <translation>Schreiben Sie die Bahn als CSV oder JSON.</translation>
    </message>
    <message>
        <source>the path has %1 motions, and a program can have %2</source>
        <translation>die Bahn hat %1 Bewegungen, ein Programm kann %2 haben</translation>
    </message>
    <message>
        <source>Divide the path.</source>
        <translation>Teilen Sie die Bahn.</translation>
    </message>
    <message>
        <source>motion %1 has a value that is not a number</source>
        <translation>Bewegung %1 hat einen Wert, der keine Zahl ist</translation>
    </message>
    <message>
        <source>Plan the path again.</source>
        <translation>Planen Sie die Bahn neu.</translation>
    </message>
    <message>
        <source>the robot carries &apos;%1&apos;, so its tool cannot work on it</source>
        <translation>der Roboter trägt „%1“, deshalb kann sein Werkzeug ihn nicht bearbeiten</translation>
    </message>
    <message>
        <source>Choose a part that stands in the cell, or take it off the robot.</source>
        <translation>Wählen Sie ein Teil, das in der Zelle steht, oder nehmen Sie es vom Roboter.</translation>
    </message>
    <message>
        <source>no such curve was found on &apos;%1&apos;</source>
        <translation>auf „%1“ wurde keine solche Kurve gefunden</translation>
    </message>
    <message>
        <source>Choose a place on a sharp edge of the part, or a section through it.</source>
        <translation>Wählen Sie einen Punkt an einer scharfen Kante des Teils, oder einen Schnitt hindurch.</translation>
    </message>
    <message>
        <source>Move the part nearer, turn the tool, or let it turn about its own axis.</source>
        <translation>Rücken Sie das Teil näher, drehen Sie das Werkzeug, oder lassen Sie es sich um seine Achse drehen.</translation>
    </message>
    <message>
        <source>Divide the curve, turn the tool, or let it turn about its own axis.</source>
        <translation>Teilen Sie die Kurve, drehen Sie das Werkzeug, oder lassen Sie es sich um seine Achse drehen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither a configuration or target of the cell nor a value for each joint</source>
        <translation>„%1“ ist weder eine Stellung oder ein Ziel der Zelle noch ein Wert für jedes Gelenk</translation>
    </message>
    <message>
        <source>Name a configuration or a target, or give the joint values in radians (&apos;0 0.5 -1 …&apos;).</source>
        <translation>Nennen Sie eine Stellung oder ein Ziel, oder geben Sie die Gelenkwerte im Bogenmaß an („0 0.5 -1 …“).</translation>
    </message>
    <message>
        <source>Name a file of one of these kinds, or a robot as irb120 or ur5.</source>
        <translation>Nennen Sie eine Datei einer dieser Arten oder einen Roboter wie irb120 oder ur5.</translation>
    </message>
    <message>
        <source>the cell already has a configuration or a target called &apos;%1&apos;</source>
        <translation>die Zelle hat schon eine Stellung oder ein Ziel mit dem Namen „%1“</translation>
    </message>
    <message>
        <source>the body that the target &apos;%1&apos; is on was removed</source>
        <translation>der Körper, auf dem das Ziel „%1“ liegt, wurde entfernt</translation>
    </message>
    <message>
        <source>Undo that, or remove the target.</source>
        <translation>Machen Sie das rückgängig, oder entfernen Sie das Ziel.</translation>
    </message>
    <message>
        <source>Choose a nearer place, or turn the tool.</source>
        <translation>Wählen Sie einen näheren Ort, oder drehen Sie das Werkzeug.</translation>
    </message>
    <message>
        <source>Choose another place, or turn the tool.</source>
        <translation>Wählen Sie einen anderen Ort, oder drehen Sie das Werkzeug.</translation>
    </message>
    <message>
        <source>Choose another place, turn the tool, or require less clearance.</source>
        <translation>Wählen Sie einen anderen Ort, drehen Sie das Werkzeug, oder verlangen Sie weniger Abstand.</translation>
    </message>
    <message>
        <source>the bar is that of the exercise, so it cannot change</source>
        <translation>die Stange gehört zur Übung und lässt sich deshalb nicht ändern</translation>
    </message>
    <message>
        <source>Work with this bar. The teacher changes it in the file of the exercise.</source>
        <translation>Arbeiten Sie mit dieser Stange. Die Lehrkraft ändert sie in der Datei der Übung.</translation>
    </message>
    <message>
        <source>the %2 of motion %1 is %4 in the program, and %3 in the path</source>
        <translation>bei Bewegung %1 ist %2 im Programm %4 und in der Bahn %3</translation>
    </message>
    <message>
        <source>Report this to the author of the post-processor; the program was not written.</source>
        <translation>Melden Sie dies dem Autor des Postprozessors; das Programm wurde nicht geschrieben.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither a URDF, a table after Denavit and Hartenberg, a robot cell nor a built-in robot</source>
        <translation>„%1“ ist weder eine URDF-Datei noch eine Tabelle nach Denavit und Hartenberg, eine Roboterzelle oder ein eingebauter Roboter</translation>
    </message>
    <message>
        <source>on the straight line to %1 the robot collides: %2 with %3</source>
        <translation>auf der geraden Linie nach %1 stößt der Roboter an: %2 mit %3</translation>
    </message>
    <message>
        <source>Remove what is not needed any more, or plan it in another cell.</source>
        <translation>Entfernen Sie, was nicht mehr gebraucht wird, oder planen Sie es in einer anderen Zelle.</translation>
    </message>
    <message>
        <source>the cell has no robot called &apos;%1&apos;</source>
        <translation>die Zelle hat keinen Roboter mit dem Namen „%1“</translation>
    </message>
    <message>
        <source>Name one of its robots (&apos;inspect&apos; lists them).</source>
        <translation>Nennen Sie einen ihrer Roboter („inspect“ zeigt sie).</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be the name of a robot</source>
        <translation>„%1“ kann nicht der Name eines Roboters sein</translation>
    </message>
    <message>
        <source>Choose another name, of one line.</source>
        <translation>Wählen Sie einen anderen, einzeiligen Namen.</translation>
    </message>
    <message>
        <source>%1 is the only robot of the cell, which must have one</source>
        <translation>%1 ist der einzige Roboter der Zelle, und einen muss sie haben</translation>
    </message>
    <message>
        <source>Add another robot before this one is removed.</source>
        <translation>Fügen Sie einen anderen Roboter hinzu, bevor dieser entfernt wird.</translation>
    </message>
    <message>
        <source>Move the other robots and the bodies instead.</source>
        <translation>Bewegen Sie stattdessen die anderen Roboter und die Körper.</translation>
    </message>
    <message>
        <source>Choose that robot first; on the command line: --arm.</source>
        <translation>Wählen Sie zuerst diesen Roboter; auf der Befehlszeile: --arm.</translation>
    </message>
    <message>
        <source>Give this field of the exercise another value.</source>
        <translation>Geben Sie diesem Feld der Übung einen anderen Wert.</translation>
    </message>
    <message>
        <source>In a copy of the program, replace it by the motions that it leads to, or remove it.</source>
        <translation>Ersetzen Sie es in einer Kopie des Programms durch die Bewegungen, zu denen es führt, oder entfernen Sie es.</translation>
    </message>
    <message>
        <source>voxels of %1 mm are too fine for a part of %2 mm</source>
        <translation>Voxel von %1 mm sind zu fein für ein Teil von %2 mm</translation>
    </message>
    <message>
        <source>Choose voxels of at least %3 mm.</source>
        <translation>Wählen Sie Voxel von mindestens %3 mm.</translation>
    </message>
    <message>
        <source>Choose larger voxels, or close other programs.</source>
        <translation>Wählen Sie größere Voxel, oder schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>Choose larger voxels, or work on a piece of the part.</source>
        <translation>Wählen Sie größere Voxel, oder arbeiten Sie an einem Stück des Teils.</translation>
    </message>
    <message>
        <source>Choose smaller voxels.</source>
        <translation>Wählen Sie kleinere Voxel.</translation>
    </message>
    <message>
        <source>Import a target, or turn a model solution and take it as the target.</source>
        <translation>Importieren Sie ein Ziel, oder drehen Sie eine Musterlösung, und übernehmen Sie sie als Ziel.</translation>
    </message>
    <message>
        <source>Turn the part first, or import the target from a drawing.</source>
        <translation>Drehen Sie zuerst das Teil, oder importieren Sie das Ziel aus einer Zeichnung.</translation>
    </message>
    <message>
        <source>%1: there is no mark “%2”</source>
        <translation>%1: es gibt kein Kriterium „%2“</translation>
    </message>
    <message>
        <source>Put “;” between the names of several marks. There are: %3.</source>
        <translation>Setzen Sie „;“ zwischen die Namen mehrerer Kriterien. Es gibt: %3.</translation>
    </message>
    <message>
        <source>Add what is marked in “Criteria” first.</source>
        <translation>Fügen Sie zuerst unter „Kriterien“ hinzu, was bewertet wird.</translation>
    </message>
    <message>
        <source>there is no drill “%1”</source>
        <translation>es gibt keinen Bohrer „%1“</translation>
    </message>
    <message>
        <source>there is no material “%1” to be drilled</source>
        <translation>es gibt keinen Werkstoff „%1“ zum Bohren</translation>
    </message>
    <message>
        <source>&apos;handwheel help drill&apos; lists the materials.</source>
        <translation>„handwheel help drill“ führt die Werkstoffe auf.</translation>
    </message>
    <message>
        <source>Choose another range; bone in a CT begins at about 300.</source>
        <translation>Wählen Sie einen anderen Bereich; Knochen beginnt in einem CT bei etwa 300.</translation>
    </message>
    <message>
        <source>Use a joint motion, or choose the same configuration at both ends.</source>
        <translation>Verwenden Sie eine Gelenkbewegung, oder wählen Sie an beiden Enden dieselbe Stellung.</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; leads along the curve where &apos;%2&apos; was when it was planned</source>
        <translation>die Bahn „%1“ führt entlang der Kurve, wo „%2“ beim Planen stand</translation>
    </message>
    <message>
        <source>Plan it again, or write it as it is; on the command line: --outdated.</source>
        <translation>Planen Sie sie neu, oder schreiben Sie sie, wie sie ist; auf der Befehlszeile: --outdated.</translation>
    </message>
    <message>
        <source>places %1 and %2 of the curve are not connected by the surface</source>
        <translation>die Punkte %1 und %2 der Kurve sind nicht über die Oberfläche verbunden</translation>
    </message>
    <message>
        <source>Draw around the gap, or place more points.</source>
        <translation>Zeichnen Sie um die Lücke herum, oder setzen Sie mehr Punkte.</translation>
    </message>
    <message>
        <source>the cell would have %2 %1, and it can contain %3</source>
        <translation>die Zelle hätte %2 %1, und sie kann %3 aufnehmen</translation>
    </message>
    <message>
        <source>the base of %1 is the origin of the cell</source>
        <translation>die Basis von %1 ist der Ursprung der Zelle</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to another robot than the one to plan for: %2</source>
        <translation>„%1“ gehört zu einem anderen Roboter als dem, für den geplant wird: %2</translation>
    </message>
    <message>
        <source>the exercise does not specify its subject</source>
        <translation>die Übung gibt ihren Gegenstand nicht an</translation>
    </message>
    <message>
        <source>nothing was turned in this work; it is the bar itself</source>
        <translation>an dieser Arbeit wurde nichts gedreht; sie ist die Stange selbst</translation>
    </message>
    <message>
        <source>nothing was drilled in this work</source>
        <translation>in dieser Arbeit wurde nichts gebohrt</translation>
    </message>
    <message>
        <source>Drill the hole first; it becomes the planned path.</source>
        <translation>Bohren Sie zuerst das Loch; es wird zur geplanten Bahn.</translation>
    </message>
    <message>
        <source>the file contains %1 separate outlines, and a profile is a single one</source>
        <translation>die Datei enthält %1 getrennte Umrisse, und ein Profil ist ein einziger</translation>
    </message>
    <message>
        <source>the outline has too many reversals to be checked</source>
        <translation>der Umriss hat zu viele Richtungsumkehrungen, um geprüft zu werden</translation>
    </message>
    <message>
        <source>the file contains %1 solids, and a target is a single one</source>
        <translation>die Datei enthält %1 Volumenkörper, und ein Ziel ist ein einziger</translation>
    </message>
    <message>
        <source>joint %2 of the arm is prismatic, which %1 programs do not support</source>
        <translation>Gelenk %2 des Arms ist ein Schubgelenk, und Programme in %1 unterstützen das nicht</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not supported, and may change where or whether the robot moves</source>
        <translation>„%1“ wird nicht unterstützt und kann ändern, wohin oder ob sich der Roboter bewegt</translation>
    </message>
    <message>
        <source>motion %1 is a line at %2 mm/s, and %3 controllers accept at most %4 mm/s</source>
        <translation>Bewegung %1 ist eine Linie mit %2 mm/s, und Steuerungen mit %3 nehmen höchstens %4 mm/s an</translation>
    </message>
    <message>
        <source>Lower the speed of the place at its end.</source>
        <translation>Verringern Sie die Geschwindigkeit des Punkts an ihrem Ende.</translation>
    </message>
    <message>
        <source>voxels of %1 mm would need %2 MB, and %3 MB are available</source>
        <translation>Voxel von %1 mm würden %2 MB brauchen, und %3 MB sind verfügbar</translation>
    </message>
    <message>
        <source>voxels of %1 mm make a volume of %2 MB, and a document can contain %3 MB</source>
        <translation>Voxel von %1 mm ergeben ein Volumen von %2 MB, und ein Dokument kann %3 MB enthalten</translation>
    </message>
    <message>
        <source>an image of %1 MB with %2 MB of voxels is too large: %3 MB is the most</source>
        <translation>ein Bild von %1 MB mit %2 MB an Voxeln ist zu groß: %3 MB sind das Höchste</translation>
    </message>
    <message>
        <source>Choose larger voxels; &apos;handwheel segment&apos; keeps no image.</source>
        <translation>Wählen Sie größere Voxel; „handwheel segment“ behält kein Bild.</translation>
    </message>
    <message>
        <source>no voxel of %1 mm lies inside the part, which is thinner than that</source>
        <translation>kein Voxel von %1 mm liegt innerhalb des Teils; es ist dünner als das</translation>
    </message>
    <message>
        <source>the surface encloses no volume</source>
        <translation>die Oberfläche schließt kein Volumen ein</translation>
    </message>
    <message>
        <source>nothing is left of the material</source>
        <translation>vom Material bleibt nichts übrig</translation>
    </message>
    <message>
        <source>Check where the bodies are, or choose a smaller distance.</source>
        <translation>Prüfen Sie, wo die Körper sind, oder wählen Sie einen kleineren Abstand.</translation>
    </message>
    <message>
        <source>a wall of %1 mm is thinner than two voxels of %2 mm</source>
        <translation>eine Wand von %1 mm ist dünner als zwei Voxel von %2 mm</translation>
    </message>
    <message>
        <source>Choose a thicker wall, or voxels of at most %3 mm.</source>
        <translation>Wählen Sie eine dickere Wand, oder Voxel von höchstens %3 mm.</translation>
    </message>
    <message>
        <source>Choose a lower rate, or a part of the path.</source>
        <translation>Wählen Sie eine niedrigere Taktrate oder einen Teil der Bahn.</translation>
    </message>
    <message>
        <source>no sample has a value from %1 to %2: the values of the image range from %3 to %4</source>
        <translation>kein Abtastwert hat einen Wert von %1 bis %2: Die Werte des Bildes reichen von %3 bis %4</translation>
    </message>
    <message>
        <source>Turn its faces outwards, or make walls of sheets: &apos;handwheel voxelize --wall MM&apos;.</source>
        <translation>Kehren Sie ihre Flächen nach außen, oder machen Sie aus offenen Flächen Wände: „handwheel voxelize --wall MM“.</translation>
    </message>
    <message>
        <source>“%1” has no meaning for a drilling program here</source>
        <translation>„%1“ hat hier in einem Bohrprogramm keine Bedeutung</translation>
    </message>
    <message>
        <source>Drill by G0, G1, G81, G82, G83, G80, G98, G99 and G4, in millimetres and absolute.</source>
        <translation>Bohren Sie mit G0, G1, G81, G82, G83, G80, G98, G99 und G4, in Millimetern und absolut.</translation>
    </message>
    <message>
        <source>%1 is missing, which %2 needs</source>
        <translation>%1 fehlt und wird von %2 benötigt</translation>
    </message>
    <message>
        <source>%1 has a value that it cannot have (%2)</source>
        <translation>%1 hat einen Wert, der nicht zulässig ist (%2)</translation>
    </message>
    <message>
        <source>the program has more than %1 moves</source>
        <translation>das Programm hat mehr als %1 Bewegungen</translation>
    </message>
    <message>
        <source>Choose larger pecks, or a part of the program.</source>
        <translation>Wählen Sie größere Zustellungen beim Tiefbohren (Q), oder einen Teil des Programms.</translation>
    </message>
    <message>
        <source>the program moves nothing</source>
        <translation>das Programm bewegt nichts</translation>
    </message>
    <message>
        <source>It begins with a move of all three axes, such as G0 X0 Y0 Z10.</source>
        <translation>Es beginnt mit einer Bewegung aller drei Achsen, wie G0 X0 Y0 Z10.</translation>
    </message>
    <message>
        <source>the picture of format %1 is damaged, or not one that can be read</source>
        <translation>das Bild im Format %1 ist beschädigt oder kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>nothing stands out in it: all is black, or of one height</source>
        <translation>nichts hebt sich darin ab: alles ist schwarz oder gleich hoch</translation>
    </message>
    <message>
        <source>Choose a picture with bright places, or a shape that rises along z.</source>
        <translation>Wählen Sie ein Bild mit hellen Stellen oder eine Form, die entlang z ansteigt.</translation>
    </message>
    <message>
        <source>Write passes of tools that turn, bore or drill.</source>
        <translation>Schreiben Sie Schnitte von Werkzeugen, die drehen, ausdrehen oder bohren.</translation>
    </message>
    <message>
        <source>voxels of %1 mm would need %2 MB, which is more than a quarter of the %3 MB that are available</source>
        <translation>Voxel von %1 mm würden %2 MB brauchen, mehr als ein Viertel der verfügbaren %3 MB</translation>
    </message>
    <message>
        <source>Choose larger voxels, or confirm it with --yes.</source>
        <translation>Wählen Sie größere Voxel, oder bestätigen Sie es mit --yes.</translation>
    </message>
    <message>
        <source>voxels of %1 mm would keep %2 % of the surface, and at least %3 % are needed</source>
        <translation>Voxel von %1 mm würden %2 % der Oberfläche erhalten, und mindestens %3 % sind nötig</translation>
    </message>
    <message>
        <source>Walls thinner than a voxel are lost: choose smaller voxels, or a wall thickness.</source>
        <translation>Wände dünner als ein Voxel gehen verloren: Wählen Sie kleinere Voxel oder eine Wandstärke.</translation>
    </message>
    <message>
        <source>Walls thinner than a voxel are lost: choose smaller voxels.</source>
        <translation>Wände dünner als ein Voxel gehen verloren: Wählen Sie kleinere Voxel.</translation>
    </message>
    <message>
        <source>Write ball, burr, twist or saw with a diameter from 0.05 to 200 mm, such as ball:6.</source>
        <translation>Schreiben Sie ball, burr, twist oder saw mit einem Durchmesser von 0,05 bis 200 mm, zum Beispiel ball:6.</translation>
    </message>
    <message>
        <source>voxels of %1 mm would contain %2 mm³, and at least %3 mm³ are needed</source>
        <translation>Voxel von %1 mm würden %2 mm³ enthalten, und mindestens %3 mm³ sind nötig</translation>
    </message>
    <message>
        <source>the cell has no frame called &apos;%1&apos;</source>
        <translation>die Zelle hat kein Bezugssystem namens „%1“</translation>
    </message>
    <message>
        <source>Name one of its frames (&apos;inspect&apos; lists them).</source>
        <translation>Nennen Sie eines ihrer Bezugssysteme („inspect“ zählt sie auf).</translation>
    </message>
    <message>
        <source>what carries the frame &apos;%1&apos; was removed</source>
        <translation>was das Bezugssystem „%1“ trägt, wurde entfernt</translation>
    </message>
    <message>
        <source>Undo that, or set the frame anew.</source>
        <translation>Machen Sie das rückgängig, oder setzen Sie das Bezugssystem neu.</translation>
    </message>
    <message>
        <source>the robot moves the frame &apos;%1&apos;, so that no program can be written in it</source>
        <translation>der Roboter bewegt das Bezugssystem „%1“, sodass kein Programm darin geschrieben werden kann</translation>
    </message>
    <message>
        <source>Choose a frame that stands still while the robot moves.</source>
        <translation>Wählen Sie ein Bezugssystem, das steht, während sich der Roboter bewegt.</translation>
    </message>
    <message>
        <source>the path takes %1 s, and at most %2 s can be followed at this rate</source>
        <translation>die Bahn dauert %1 s, und bei dieser Rate können höchstens %2 s verfolgt werden</translation>
    </message>
    <message>
        <source>a tool with a radius of %1 mm does not suit voxels of %2 mm: from %3 to %4 mm it does</source>
        <translation>ein Werkzeug mit einem Radius von %1 mm passt nicht zu Voxeln von %2 mm: von %3 bis %4 mm passt es</translation>
    </message>
    <message>
        <source>Choose another radius, or other voxels.</source>
        <translation>Wählen Sie einen anderen Radius oder andere Voxel.</translation>
    </message>
    <message>
        <source>the strokes go %1 mm, and a tool with a radius of %2 mm can be led %3 mm at most</source>
        <translation>die Striche gehen über %1 mm, und ein Werkzeug mit einem Radius von %2 mm kann höchstens %3 mm geführt werden</translation>
    </message>
    <message>
        <source>Check the unit of the places, or divide the strokes.</source>
        <translation>Prüfen Sie die Einheit der Orte, oder teilen Sie die Striche auf.</translation>
    </message>
    <message>
        <source>the layer “%1” takes no strokes, as it is off, or its strength is below 1</source>
        <translation>die Ebene „%1“ nimmt keine Striche an, weil sie aus ist oder ihre Stärke unter 1 liegt</translation>
    </message>
    <message>
        <source>Turn it on with a strength of 1, or add a layer above it.</source>
        <translation>Schalten Sie sie mit der Stärke 1 ein, oder fügen Sie darüber eine Ebene hinzu.</translation>
    </message>
    <message>
        <source>the layer “%1” takes no strokes, as the layer “%2” is above it</source>
        <translation>die Ebene „%1“ nimmt keine Striche an, weil die Ebene „%2“ darüber liegt</translation>
    </message>
    <message>
        <source>Merge the layers above it, or name a new layer.</source>
        <translation>Verschmelzen Sie die Ebenen darüber, oder nennen Sie eine neue Ebene.</translation>
    </message>
    <message>
        <source>a volume has at most %1 layers</source>
        <translation>ein Volumen hat höchstens %1 Ebenen</translation>
    </message>
    <message>
        <source>Merge some of them first.</source>
        <translation>Verschmelzen Sie zuerst einige davon.</translation>
    </message>
    <message>
        <source>the curve of the path &apos;%1&apos; was planned with another tool centre point</source>
        <translation>die Kurve der Bahn &apos;%1&apos; wurde mit einem anderen Werkzeugmittelpunkt geplant</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; leads to where the target &apos;%2&apos; was when it was planned</source>
        <translation>die Bahn &apos;%1&apos; führt dorthin, wo das Ziel &apos;%2&apos; beim Planen war</translation>
    </message>
    <message>
        <source>the file is open in another tab, and would be replaced</source>
        <translation>die Datei ist in einem anderen Tab geöffnet und würde ersetzt</translation>
    </message>
    <message>
        <source>Choose another name, or close the other tab first.</source>
        <translation>Wählen Sie einen anderen Namen, oder schließen Sie zuerst den anderen Tab.</translation>
    </message>
    <message>
        <source>the robot stood elsewhere when the curve of the path &apos;%1&apos; was planned</source>
        <translation>der Roboter stand woanders, als die Kurve der Bahn „%1“ geplant wurde</translation>
    </message>
    <message>
        <source>Move the robot away there, or let two bodies touch that are meant to.</source>
        <translation>Den Roboter dort wegbewegen oder zwei Körper sich berühren lassen, die es sollen.</translation>
    </message>
    <message>
        <source>at %1 the robot is too near: %2 is %4 mm from %3</source>
        <translation>bei %1 ist der Roboter zu nah: %2 ist %4 mm von %3 entfernt</translation>
    </message>
    <message>
        <source>Move the robot away there, or require less clearance.</source>
        <translation>Den Roboter dort wegbewegen oder weniger Abstand verlangen.</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; leads to &apos;%2&apos; as that was stored when it was planned</source>
        <translation>die Bahn „%1“ führt zu „%2“, wie es bei ihrer Planung gespeichert war</translation>
    </message>
    <message>
        <source>Use a joint motion, change either place, or let bodies touch that are meant to.</source>
        <translation>Eine Gelenkbewegung verwenden, eine der Stellen ändern oder Körper sich berühren lassen, die es sollen.</translation>
    </message>
    <message>
        <source>on the straight line to %1 the robot is too near: %2 is %4 mm from %3</source>
        <translation>auf der geraden Strecke zu %1 ist der Roboter zu nah: %2 ist %4 mm von %3 entfernt</translation>
    </message>
    <message>
        <source>Use a joint motion, change this place or the one before, or require less clearance.</source>
        <translation>Eine Gelenkbewegung verwenden, diese oder die vorige Stelle ändern oder weniger Abstand verlangen.</translation>
    </message>
    <message>
        <source>Tilt the tool away, keep a distance or less clearance, or let it touch the part.</source>
        <translation>Das Werkzeug wegneigen, eine Entfernung oder weniger Abstand halten oder es das Teil berühren lassen.</translation>
    </message>
    <message>
        <source>the pose is in the base of the controller, which the description of %1 does not have</source>
        <translation>die Pose gilt in der Basis der Steuerung, die die Beschreibung von %1 nicht hat</translation>
    </message>
    <message>
        <source>Use the built-in robot, add a link &apos;base&apos; to the description, or give the motions joint values.</source>
        <translation>Den eingebauten Roboter verwenden, der Beschreibung ein Glied „base“ hinzufügen oder den Bewegungen Gelenkwerte geben.</translation>
    </message>
    <message>
        <source>the robot cannot reach point %1 of %2 of the curve, at X %3 Y %4 Z %5 mm in the cell</source>
        <translation>der Roboter kann Punkt %1 von %2 der Kurve nicht erreichen, bei X %3 Y %4 Z %5 mm in der Zelle</translation>
    </message>
    <message>
        <source>at point %1 of %2 of the curve, X %3 Y %4 Z %5 mm in the cell, the robot collides: %6 with %7</source>
        <translation>bei Punkt %1 von %2 der Kurve, X %3 Y %4 Z %5 mm in der Zelle, stößt der Roboter an: %6 mit %7</translation>
    </message>
    <message>
        <source>the arm cannot follow the curve to point %1 of %2, X %3 Y %4 Z %5 mm in the cell, without a jump of a joint</source>
        <translation>der Arm kann der Kurve nicht bis Punkt %1 von %2, bei X %3 Y %4 Z %5 mm in der Zelle, folgen, ohne dass ein Gelenk springt</translation>
    </message>
    <message>
        <source>the arm cannot bring its tool to X %1 Y %2 Z %3 mm in the cell in this orientation</source>
        <translation>der Arm kann sein Werkzeug in dieser Ausrichtung nicht nach X %1 Y %2 Z %3 mm in der Zelle bringen</translation>
    </message>
    <message>
        <source>to bring the tool to X %1 Y %2 Z %3 mm in the cell in this orientation, joint %4 would exceed its limits</source>
        <translation>um das Werkzeug in dieser Ausrichtung nach X %1 Y %2 Z %3 mm in der Zelle zu bringen, müsste das Gelenk %4 seine Grenzen überschreiten</translation>
    </message>
    <message>
        <source>with its tool at X %1 Y %2 Z %3 mm in the cell the robot collides in every configuration: %4 with %5</source>
        <translation>mit dem Werkzeug bei X %1 Y %2 Z %3 mm in der Zelle kollidiert der Roboter in jeder Stellung: %4 mit %5</translation>
    </message>
    <message>
        <source>along the line the arm does not come to its end with configuration %1, and controllers stop</source>
        <translation>entlang der Geraden kommt der Arm nicht mit der Konfiguration %1 an ihr Ende, und Steuerungen halten an</translation>
    </message>
    <message>
        <source>In a copy of the program, correct the configuration, or write ConfL\Off before the line.</source>
        <translation>Berichtigen Sie in einer Kopie des Programms die Konfiguration, oder schreiben Sie ConfL\Off vor die Zeile.</translation>
    </message>
    <message>
        <source>the folder contains no DICOM files</source>
        <translation>der Ordner enthält keine DICOM-Dateien</translation>
    </message>
    <message>
        <source>Choose a file, or the folder in which the slices are; folders in it are not searched.</source>
        <translation>Wählen Sie eine Datei oder den Ordner, in dem die Schichten liegen; Unterordner werden nicht durchsucht.</translation>
    </message>
    <message>
        <source>all passes were made with a file, paper or a disk, or are threads that no program can cut</source>
        <translation>alle Schnitte wurden mit Feile, Papier oder Scheibe gemacht oder sind Gewinde, die kein Programm schneiden kann</translation>
    </message>
    <message>
        <source>%2: %3</source>
        <translation>%2: %3</translation>
    </message>
    <message>
        <source>%4 Then make the program again.</source>
        <translation>%4 Erzeugen Sie das Programm dann erneut.</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; is not proven free: the shape of %2 (%3) could not be read</source>
        <translation>für den Weg „%1“ ist nicht bewiesen, dass er frei ist: die Form von %2 (%3) konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>Replace it by a body that the link carries, or leave it out of proofs, in the panel Cell or by &apos;handwheel set CELL missing.LINK=…&apos;.</source>
        <translation>Ersetzen Sie sie durch einen Körper, den das Glied trägt, oder lassen Sie sie bei Beweisen weg: im Feld Zelle oder mit „handwheel set CELL missing.LINK=…“.</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; is not proven: CNT rounds the corner at place %2, and not everything within the corner is free</source>
        <translation>die Bahn &apos;%1&apos; ist nicht bewiesen: CNT verrundet die Ecke an Stelle %2, und nicht alles innerhalb der Ecke ist frei</translation>
    </message>
    <message>
        <source>Set its rounding to 0 (FINE), or change the places; on the command line: --cnt-as-fine.</source>
        <translation>Die Verrundung auf 0 setzen (FINE) oder die Stellen ändern; auf der Befehlszeile: --cnt-as-fine.</translation>
    </message>
    <message>
        <source>the proof of the path &apos;%1&apos; ends at place %2: &apos;%3&apos; may grip or release something</source>
        <translation>der Beweis der Bahn &apos;%1&apos; endet an Stelle %2: &apos;%3&apos; kann etwas greifen oder loslassen</translation>
    </message>
    <message>
        <source>Say at that place that the robot carries the same as before; on the command line: --carried same.</source>
        <translation>An dieser Stelle angeben, dass der Roboter dasselbe trägt wie zuvor; auf der Befehlszeile: --carried same.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a line of %3, and %2 programs cannot have it (lines: %4)</source>
        <translation>&apos;%1&apos; ist eine Zeile von %3, die Programme von %2 nicht haben können (Zeilen: %4)</translation>
    </message>
    <message>
        <source>Write the program in its own language, or without these lines; on the command line: --without-io.</source>
        <translation>Das Programm in seiner eigenen Sprache schreiben oder ohne diese Zeilen; auf der Befehlszeile: --without-io.</translation>
    </message>
    <message>
        <source>motion %1 ends with the rounding CNT, which %2 programs do not have</source>
        <translation>Bewegung %1 endet mit der Verrundung CNT, die Programme von %2 nicht haben</translation>
    </message>
    <message>
        <source>Set the rounding of the place to 0 (FINE), and a blend if need be; on the command line: --cnt-as-fine.</source>
        <translation>Die Verrundung der Stelle auf 0 setzen (FINE) und nötigenfalls ein Überschleifen; auf der Befehlszeile: --cnt-as-fine.</translation>
    </message>
    <message>
        <source>Use the built-in robot irb2400, or write the path as CSV or JSON.</source>
        <translation>Nehmen Sie den eingebauten Roboter irb2400, oder schreiben Sie den Pfad als CSV oder JSON.</translation>
    </message>
    <message>
        <source>Move joints 2 and 3 at that place, and verify the path again.</source>
        <translation>Bewegen Sie dort die Gelenke 2 und 3, und prüfen Sie den Pfad noch einmal.</translation>
    </message>
    <message>
        <source>the description of %1 lacks its parallel linkage, which %2 counts with</source>
        <translation>der Beschreibung von %1 fehlt das Parallelgestänge, mit dem %2 zählt</translation>
    </message>
    <message>
        <source>motion %1 ends with axis 3 at %2° from the level, beyond %3° to %4°</source>
        <translation>Bewegung %1 endet mit Achse 3 bei %2° gegen die Waagerechte, außerhalb von %3° bis %4°</translation>
    </message>
    <message>
        <source>the motion turns joint %1 by %2°, and the description of the robot has no limits for it, so that paths turn it the shorter way</source>
        <translation>die Bewegung dreht Gelenk %1 um %2°, und die Beschreibung des Roboters hat keine Grenzen dafür, sodass Bahnen es auf dem kürzeren Weg drehen</translation>
    </message>
    <message>
        <source>Give the joint its limits in the description, or divide the motion.</source>
        <translation>Geben Sie dem Gelenk in der Beschreibung seine Grenzen, oder teilen Sie die Bewegung.</translation>
    </message>
    <message>
        <source>the controller moves %1 %2 %3, which is %4° there, from %5° to %6° only</source>
        <translation>Die Steuerung bewegt %1 %2 %3 nur von %5° bis %6°, und dort sind es %4°</translation>
    </message>
    <message>
        <source>Check that the program is for this robot, and change the joints there.</source>
        <translation>Prüfen Sie, ob das Programm für diesen Roboter ist, und ändern Sie dort die Gelenke.</translation>
    </message>
    <message>
        <source>the path &apos;%1&apos; leads to where the frame &apos;%2&apos; was when its program was opened</source>
        <translation>Die Bahn „%1“ führt dorthin, wo das Koordinatensystem „%2“ war, als ihr Programm geöffnet wurde</translation>
    </message>
    <message>
        <source>Open the program again or plan the path again, or write it as it is; on the command line: --outdated.</source>
        <translation>Öffnen Sie das Programm erneut oder planen Sie die Bahn erneut, oder schreiben Sie sie, wie sie ist; auf der Befehlszeile: --outdated.</translation>
    </message>
    <message>
        <source>the robot does not reach this place in the configuration that the program gives</source>
        <translation>Der Roboter erreicht diese Stelle nicht in der Konfiguration, die das Programm angibt</translation>
    </message>
    <message>
        <source>Check that the program is for this robot, its tool and its frame, or correct the configuration in a copy of the program.</source>
        <translation>Prüfen Sie, ob das Programm für diesen Roboter, sein Werkzeug und sein Koordinatensystem ist, oder berichtigen Sie die Konfiguration in einer Kopie des Programms.</translation>
    </message>
    <message>
        <source>the tool or frame of this place is on the controller, not in the file, or it moves</source>
        <translation>Werkzeug oder Koordinatensystem dieser Stelle ist auf der Steuerung und nicht in der Datei, oder es bewegt sich</translation>
    </message>
    <message>
        <source>Add its data to a copy of the program, or create a frame of that name in the cell.</source>
        <translation>Fügen Sie seine Daten in eine Kopie des Programms ein, oder legen Sie in der Zelle ein Koordinatensystem dieses Namens an.</translation>
    </message>
    <message>
        <source>the place is the result of the function %1, which is not supported</source>
        <translation>Die Stelle ist das Ergebnis der Funktion %1, die nicht unterstützt wird</translation>
    </message>
    <message>
        <source>In a copy of the program, replace it by the numbers that it returns.</source>
        <translation>Ersetzen Sie sie in einer Kopie des Programms durch die Zahlen, die sie ergibt.</translation>
    </message>
</context>
<context>
    <name>ErrorWord</name>
    <message>
        <source>bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>entries</source>
        <translation>Einträge</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>facets</source>
        <translation>Facetten</translation>
    </message>
    <message>
        <source>numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>poles</source>
        <translation>Pole</translation>
    </message>
    <message>
        <source>strips</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>a count</source>
        <translation>eine Anzahl</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a statement of the format</source>
        <translation>eine Anweisung des Formats</translation>
    </message>
    <message>
        <source>a vertex number</source>
        <translation>eine Eckpunktnummer</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>das Zeilenende</translation>
    </message>
    <message>
        <source>the number of faces</source>
        <translation>die Anzahl der Flächen</translation>
    </message>
    <message>
        <source>the number of vertices</source>
        <translation>die Anzahl der Eckpunkte</translation>
    </message>
    <message>
        <source>the 3D model</source>
        <translation>das 3D-Modell</translation>
    </message>
    <message>
        <source>the joint</source>
        <translation>das Gelenk</translation>
    </message>
    <message>
        <source>the link</source>
        <translation>das Glied</translation>
    </message>
    <message>
        <source>the mesh</source>
        <translation>das Netz</translation>
    </message>
    <message>
        <source>the object</source>
        <translation>das Objekt</translation>
    </message>
    <message>
        <source>the property</source>
        <translation>die Eigenschaft</translation>
    </message>
    <message>
        <source>XML that declares entities</source>
        <translation>XML mit eigenen Entitäten</translation>
    </message>
    <message>
        <source>a skinned mesh</source>
        <translation>ein Netz mit Skelett</translation>
    </message>
    <message>
        <source>a xacro file that is not expanded to URDF</source>
        <translation>eine nicht in URDF umgewandelte Xacro-Datei</translation>
    </message>
    <message>
        <source>the 3MF extension &apos;%1&apos;</source>
        <translation>die 3MF-Erweiterung „%1“</translation>
    </message>
    <message>
        <source>the mesh name &apos;%1&apos;, which leads too far away,</source>
        <translation>der Netzname „%1“, der zu weit wegführt,</translation>
    </message>
    <message>
        <source>the mesh name &apos;%1&apos;, which leaves its package,</source>
        <translation>der Netzname „%1“, der sein Paket verlässt,</translation>
    </message>
    <message>
        <source>the mesh name &apos;%1&apos;, which names no package,</source>
        <translation>der Netzname „%1“, der kein Paket nennt,</translation>
    </message>
    <message>
        <source>the shape &apos;%1&apos;</source>
        <translation>die Form „%1“</translation>
    </message>
    <message>
        <source>a coordinate of the mesh</source>
        <translation>eine Koordinate des Netzes</translation>
    </message>
    <message>
        <source>an origin</source>
        <translation>ein Ursprung</translation>
    </message>
    <message>
        <source>chord tolerance</source>
        <translation>die Sehnentoleranz</translation>
    </message>
    <message>
        <source>it cannot be opened</source>
        <translation>sie lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>its triangles differ</source>
        <translation>ihre Dreiecke weichen ab</translation>
    </message>
    <message>
        <source>its volume differs</source>
        <translation>ihr Volumen weicht ab</translation>
    </message>
    <message>
        <source>Its directory is wrong</source>
        <translation>Sein Verzeichnis ist falsch</translation>
    </message>
    <message>
        <source>Not a regular file</source>
        <translation>Keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>it is not a STEP file</source>
        <translation>es ist keine STEP-Datei</translation>
    </message>
    <message>
        <source>the faces do not close</source>
        <translation>die Flächen schließen sich nicht</translation>
    </message>
    <message>
        <source>the faces do not join</source>
        <translation>die Flächen passen nicht aneinander</translation>
    </message>
    <message>
        <source>the file cannot be written</source>
        <translation>die Datei lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>the solid cannot be translated</source>
        <translation>der Volumenkörper lässt sich nicht umsetzen</translation>
    </message>
    <message>
        <source>%1 of its polygons cannot be read</source>
        <translation>%1 seiner Polygone sind unlesbar</translation>
    </message>
    <message>
        <source>a choice was expected</source>
        <translation>eine Auswahl wurde erwartet</translation>
    </message>
    <message>
        <source>a comment is too long</source>
        <translation>ein Kommentar ist zu lang</translation>
    </message>
    <message>
        <source>a number was expected</source>
        <translation>eine Zahl wurde erwartet</translation>
    </message>
    <message>
        <source>a pole is across the axis, too far away or not finite</source>
        <translation>ein Pol liegt jenseits der Achse, zu weit weg oder ist nicht endlich</translation>
    </message>
    <message>
        <source>a tag is too long</source>
        <translation>eine Marke ist zu lang</translation>
    </message>
    <message>
        <source>a text is too long</source>
        <translation>ein Text ist zu lang</translation>
    </message>
    <message>
        <source>a text of at most 1000 bytes in UTF-8 was expected</source>
        <translation>ein UTF-8-Text von höchstens 1000 Bytes wurde erwartet</translation>
    </message>
    <message>
        <source>a weight is missing, not positive or too large</source>
        <translation>ein Gewicht fehlt, ist nicht positiv oder zu groß</translation>
    </message>
    <message>
        <source>elements are nested too deeply</source>
        <translation>Elemente sind zu tief geschachtelt</translation>
    </message>
    <message>
        <source>it contains itself</source>
        <translation>es enthält sich selbst</translation>
    </message>
    <message>
        <source>it has a document type</source>
        <translation>es hat einen Dokumenttyp</translation>
    </message>
    <message>
        <source>it has no links</source>
        <translation>es hat keine Glieder</translation>
    </message>
    <message>
        <source>it has no name</source>
        <translation>der Name fehlt</translation>
    </message>
    <message>
        <source>it has no shape</source>
        <translation>die Form fehlt</translation>
    </message>
    <message>
        <source>it has no type</source>
        <translation>der Typ fehlt</translation>
    </message>
    <message>
        <source>it has no %1</source>
        <translation>„%1“ fehlt</translation>
    </message>
    <message>
        <source>it has too few poles</source>
        <translation>es hat zu wenige Pole</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>es fehlt</translation>
    </message>
    <message>
        <source>it is nested too deeply</source>
        <translation>es ist zu tief geschachtelt</translation>
    </message>
    <message>
        <source>it is not JSON</source>
        <translation>es ist kein JSON</translation>
    </message>
    <message>
        <source>it is not an object</source>
        <translation>es ist kein Objekt</translation>
    </message>
    <message>
        <source>it is not the root</source>
        <translation>es ist nicht die Wurzel</translation>
    </message>
    <message>
        <source>it is not twelve numbers</source>
        <translation>es sind nicht zwölf Zahlen</translation>
    </message>
    <message>
        <source>it lies on the axis</source>
        <translation>es liegt auf der Achse</translation>
    </message>
    <message>
        <source>it names no file</source>
        <translation>es nennt keine Datei</translation>
    </message>
    <message>
        <source>it names no joint</source>
        <translation>es nennt kein Gelenk</translation>
    </message>
    <message>
        <source>it names no %1</source>
        <translation>es nennt kein „%1“</translation>
    </message>
    <message>
        <source>its axis has no direction</source>
        <translation>seine Achse hat keine Richtung</translation>
    </message>
    <message>
        <source>its degree must be 1, 2 or 3</source>
        <translation>sein Grad muss 1, 2 oder 3 sein</translation>
    </message>
    <message>
        <source>its knots do not fit its poles</source>
        <translation>seine Knoten passen nicht zu seinen Polen</translation>
    </message>
    <message>
        <source>its lower limit is above the upper one</source>
        <translation>seine untere Grenze liegt über der oberen</translation>
    </message>
    <message>
        <source>its object is of the type &apos;other&apos;</source>
        <translation>sein Objekt ist vom Typ „other“</translation>
    </message>
    <message>
        <source>its type &apos;%1&apos; is not known</source>
        <translation>sein Typ „%1“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>its unit is &apos;%1&apos;</source>
        <translation>seine Einheit ist „%1“</translation>
    </message>
    <message>
        <source>its vertices have no positions</source>
        <translation>seine Eckpunkte haben keine Positionen</translation>
    </message>
    <message>
        <source>there are two of that name</source>
        <translation>es gibt zwei dieses Namens</translation>
    </message>
    <message>
        <source>the firmware file</source>
        <translation>die Firmware-Datei</translation>
    </message>
    <message>
        <source>a packet of the firmware</source>
        <translation>ein Paket der Firmware</translation>
    </message>
    <message>
        <source>an inventory with an Inverse3</source>
        <translation>eine Geräteliste mit einem Inverse3</translation>
    </message>
    <message>
        <source>the bootloader&apos;s greeting</source>
        <translation>die Begrüßung des Bootloaders</translation>
    </message>
    <message>
        <source>the echo of the first byte</source>
        <translation>das Echo des ersten Bytes</translation>
    </message>
    <message>
        <source>the firmware&apos;s echo</source>
        <translation>das Echo der Firmware</translation>
    </message>
    <message>
        <source>the handshake of a WebSocket</source>
        <translation>der Handschlag eines WebSockets</translation>
    </message>
    <message>
        <source>unplugged</source>
        <translation>ausgesteckt</translation>
    </message>
    <message>
        <source>it brings no driver</source>
        <translation>es bringt keinen Treiber mit</translation>
    </message>
    <message>
        <source>there is already a driver &apos;%1&apos;</source>
        <translation>es gibt schon einen Treiber ‚%1‘</translation>
    </message>
    <message>
        <source>ticks of the recording &apos;%1&apos;</source>
        <translation>Takte der Aufzeichnung „%1“</translation>
    </message>
    <message>
        <source>the process that guards its motors has ended</source>
        <translation>der Prozess, der seine Motoren bewacht, ist zu Ende</translation>
    </message>
    <message>
        <source>attributes</source>
        <translation>Attribute</translation>
    </message>
    <message>
        <source>events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>ticks</source>
        <translation>Takte</translation>
    </message>
    <message>
        <source>the setting</source>
        <translation>die Einstellung</translation>
    </message>
    <message>
        <source>it is not there</source>
        <translation>es ist nicht da</translation>
    </message>
    <message>
        <source>the picture has no pixels</source>
        <translation>das Bild hat keine Pixel</translation>
    </message>
    <message>
        <source>a rate or a time is not above zero</source>
        <translation>eine Rate oder eine Zeit ist nicht größer als null</translation>
    </message>
    <message>
        <source>a short list of keys is expected</source>
        <translation>eine kurze Liste von Tasten wird erwartet</translation>
    </message>
    <message>
        <source>a whole number is expected</source>
        <translation>eine ganze Zahl wird erwartet</translation>
    </message>
    <message>
        <source>an object is expected</source>
        <translation>ein Objekt wird erwartet</translation>
    </message>
    <message>
        <source>there is no such key</source>
        <translation>diese Taste gibt es nicht</translation>
    </message>
    <message>
        <source>they do not fit the mesh</source>
        <translation>sie passen nicht zum Netz</translation>
    </message>
    <message>
        <source>the number of samples is missing or impossible</source>
        <translation>die Anzahl der Punkte fehlt oder ist unmöglich</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>samples of the profile</source>
        <translation>Punkte des Profils</translation>
    </message>
    <message>
        <source>faces that can be triangulated</source>
        <translation>Flächen, die sich in Dreiecke zerlegen lassen,</translation>
    </message>
    <message>
        <source>parts that can be read</source>
        <translation>lesbare Teile</translation>
    </message>
    <message>
        <source>it crashed on this file</source>
        <translation>sie ist an dieser Datei abgestürzt</translation>
    </message>
    <message>
        <source>it takes more than %1 triangles</source>
        <translation>es wären mehr als %1 Dreiecke nötig</translation>
    </message>
    <message>
        <source>it took longer than %1 s</source>
        <translation>es dauerte länger als %1 s</translation>
    </message>
    <message>
        <source>its answer is too large</source>
        <translation>ihre Antwort ist zu groß</translation>
    </message>
    <message>
        <source>its process cannot be started</source>
        <translation>ihr Prozess lässt sich nicht starten</translation>
    </message>
    <message>
        <source>bodies</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>dimensions</source>
        <translation>Maße</translation>
    </message>
    <message>
        <source>the body</source>
        <translation>der Körper</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>die Datei</translation>
    </message>
    <message>
        <source>a link to a file name that is not UTF-8</source>
        <translation>eine Verknüpfung mit einem Dateinamen, der nicht UTF-8 ist,</translation>
    </message>
    <message>
        <source>setting %1</source>
        <translation>das Setzen von %1</translation>
    </message>
    <message>
        <source>the shape %1</source>
        <translation>die Form %1</translation>
    </message>
    <message>
        <source>a colour such as #b8bcc7 was expected</source>
        <translation>eine Farbe wie #b8bcc7 wurde erwartet</translation>
    </message>
    <message>
        <source>a text was expected</source>
        <translation>ein Text wurde erwartet</translation>
    </message>
    <message>
        <source>its pose cannot be used</source>
        <translation>seine Lage ist nicht verwendbar</translation>
    </message>
    <message>
        <source>yes or no was expected</source>
        <translation>Ja oder Nein wurde erwartet</translation>
    </message>
    <message>
        <source>the package</source>
        <translation>das Paket</translation>
    </message>
    <message>
        <source>it is longer than its size</source>
        <translation>sie ist länger als ihre Größe</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>sie ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>the position of the body</source>
        <translation>die Position des Körpers</translation>
    </message>
    <message>
        <source>its position</source>
        <translation>seine Position</translation>
    </message>
    <message>
        <source>a geometry that is not a mesh</source>
        <translation>eine Geometrie, die kein Netz ist,</translation>
    </message>
    <message>
        <source>the floating joint &apos;%1&apos;, which is treated as fixed,</source>
        <translation>das schwebende Gelenk „%1“, das als fest behandelt wird,</translation>
    </message>
    <message>
        <source>the planar joint &apos;%1&apos;, which is treated as fixed,</source>
        <translation>das ebene Gelenk „%1“, das als fest behandelt wird,</translation>
    </message>
    <message>
        <source>the mesh name &apos;%1&apos;, which is not a file on this computer,</source>
        <translation>der Netzname „%1“, der keine Datei auf diesem Rechner ist,</translation>
    </message>
    <message>
        <source>the mesh name &apos;%1&apos;, which is on another computer,</source>
        <translation>der Netzname „%1“, der auf einem anderen Rechner liegt,</translation>
    </message>
    <message>
        <source>it is inconsistent</source>
        <translation>sie ist widersprüchlich</translation>
    </message>
    <message>
        <source>its answer is not valid</source>
        <translation>ihre Antwort ist ungültig</translation>
    </message>
    <message>
        <source>it belongs to a closed loop of joints</source>
        <translation>es gehört zu einer geschlossenen Kette von Gelenken</translation>
    </message>
    <message>
        <source>the version of the format is missing</source>
        <translation>die Version des Formats fehlt</translation>
    </message>
    <message>
        <source>it mimics itself</source>
        <translation>es ahmt sich selbst nach (mimic)</translation>
    </message>
    <message>
        <source>its mimic factor or offset is too large</source>
        <translation>sein Faktor oder Versatz (mimic) ist zu groß</translation>
    </message>
    <message>
        <source>it is not a length; metres are assumed</source>
        <translation>es ist keine Länge; Meter werden angenommen</translation>
    </message>
    <message>
        <source>it is instanced too often, or within itself</source>
        <translation>es wird zu oft oder in sich selbst verwendet</translation>
    </message>
    <message>
        <source>its joints form a closed loop</source>
        <translation>seine Gelenke bilden eine geschlossene Kette</translation>
    </message>
    <message>
        <source>its loops cannot be identified any more</source>
        <translation>seine Ränder sind nicht mehr zu erkennen</translation>
    </message>
    <message>
        <source>its number %1 is already in use</source>
        <translation>seine Nummer %1 ist schon vergeben</translation>
    </message>
    <message>
        <source>its key is not a number</source>
        <translation>sein Schlüssel ist keine Zahl</translation>
    </message>
    <message>
        <source>its matrix is not a rotation</source>
        <translation>seine Matrix ist keine Drehung</translation>
    </message>
    <message>
        <source>cutting them again would take too long</source>
        <translation>sie noch einmal zu schneiden dauerte zu lange</translation>
    </message>
    <message>
        <source>its size is not a length</source>
        <translation>seine Größe ist keine Länge</translation>
    </message>
    <message>
        <source>its transformation is not valid</source>
        <translation>seine Transformation ist unverständlich</translation>
    </message>
    <message>
        <source>its triangles are inconsistent</source>
        <translation>seine Dreiecke sind widersprüchlich</translation>
    </message>
    <message>
        <source>link %1 already has a parent joint</source>
        <translation>Glied %1 hat schon ein übergeordnetes Gelenk</translation>
    </message>
    <message>
        <source>no joint connects it to %1</source>
        <translation>kein Gelenk verbindet es mit %1</translation>
    </message>
    <message>
        <source>one of its indices is not a number</source>
        <translation>einer seiner Indizes ist keine Zahl</translation>
    </message>
    <message>
        <source>it contains no valid solid</source>
        <translation>sie enthält keinen gültigen Volumenkörper</translation>
    </message>
    <message>
        <source>its surfaces have zero size</source>
        <translation>ihre Flächen haben keine Ausdehnung</translation>
    </message>
    <message>
        <source>none of its surfaces can be triangulated</source>
        <translation>keine ihrer Flächen lässt sich in Dreiecke zerlegen</translation>
    </message>
    <message>
        <source>the file contains no shape</source>
        <translation>die Datei enthält keine Form</translation>
    </message>
    <message>
        <source>the file contains no surface</source>
        <translation>die Datei enthält keine Fläche</translation>
    </message>
    <message>
        <source>the system ended it; it may have run out of memory</source>
        <translation>das System hat sie beendet; vielleicht fehlte Speicher</translation>
    </message>
    <message>
        <source>it has no limits, so it moves without limits</source>
        <translation>es hat keine Grenzen und bewegt sich ohne</translation>
    </message>
    <message>
        <source>its geometry has no type</source>
        <translation>seine Geometrie hat keinen Typ</translation>
    </message>
    <message>
        <source>its scale is degenerate</source>
        <translation>sein Maßstab ist entartet</translation>
    </message>
    <message>
        <source>segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>the number of segments is missing or impossible</source>
        <translation>die Anzahl der Segmente fehlt oder ist unmöglich</translation>
    </message>
    <message>
        <source>its radius is not above zero</source>
        <translation>sein Radius ist nicht größer als null</translation>
    </message>
    <message>
        <source>it has no extent</source>
        <translation>es hat keine Ausdehnung</translation>
    </message>
    <message>
        <source>it has no value</source>
        <translation>es hat keinen Wert</translation>
    </message>
    <message>
        <source>a command was expected</source>
        <translation>ein Befehl wurde erwartet</translation>
    </message>
    <message>
        <source>it is not one that SVG has</source>
        <translation>in SVG gibt es das nicht</translation>
    </message>
    <message>
        <source>a coordinate is too large</source>
        <translation>eine Koordinate ist zu groß</translation>
    </message>
    <message>
        <source>its answer is not understood</source>
        <translation>ihre Antwort ist unverständlich</translation>
    </message>
    <message>
        <source>its outline differs</source>
        <translation>ihr Umriss weicht ab</translation>
    </message>
    <message>
        <source>there are no fonts</source>
        <translation>es gibt keine Schriften</translation>
    </message>
    <message>
        <source>the page cannot be painted</source>
        <translation>die Seite lässt sich nicht zeichnen</translation>
    </message>
    <message>
        <source>a list was expected</source>
        <translation>eine Liste wurde erwartet</translation>
    </message>
    <message>
        <source>a nose radius is impossible</source>
        <translation>ein Eckenradius ist unmöglich</translation>
    </message>
    <message>
        <source>a number was expected, or nothing</source>
        <translation>eine Zahl wurde erwartet oder nichts</translation>
    </message>
    <message>
        <source>a range ends before it begins</source>
        <translation>ein Bereich endet, bevor er beginnt</translation>
    </message>
    <message>
        <source>a section has no corners, too many, or impossible ones</source>
        <translation>ein Abschnitt hat keine Ecken, zu viele oder unmögliche</translation>
    </message>
    <message>
        <source>a switch was expected</source>
        <translation>ein Schalter wurde erwartet</translation>
    </message>
    <message>
        <source>a text in UTF-8 was expected</source>
        <translation>ein Text in UTF-8 wurde erwartet</translation>
    </message>
    <message>
        <source>a tool is impossible</source>
        <translation>ein Werkzeug ist unmöglich</translation>
    </message>
    <message>
        <source>an object was expected</source>
        <translation>ein Objekt wurde erwartet</translation>
    </message>
    <message>
        <source>criteria</source>
        <translation>Kriterien</translation>
    </message>
    <message>
        <source>feed and spindle speed must be above 0</source>
        <translation>Vorschub und Drehzahl müssen über 0 liegen</translation>
    </message>
    <message>
        <source>it has too few points</source>
        <translation>es hat zu wenige Punkte</translation>
    </message>
    <message>
        <source>it is impossible</source>
        <translation>es ist unmöglich</translation>
    </message>
    <message>
        <source>it is not 1</source>
        <translation>es ist nicht 1</translation>
    </message>
    <message>
        <source>it is not a list of the numbers that belong there</source>
        <translation>es ist keine Liste der Zahlen, die dorthin gehören</translation>
    </message>
    <message>
        <source>it is not known</source>
        <translation>es ist nicht bekannt</translation>
    </message>
    <message>
        <source>it is too long</source>
        <translation>es ist zu lang</translation>
    </message>
    <message>
        <source>its kind is unknown</source>
        <translation>seine Art ist unbekannt</translation>
    </message>
    <message>
        <source>its time is impossible</source>
        <translation>seine Zeit ist unmöglich</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>nothing is left of the part</source>
        <translation>vom Teil ist nichts übrig</translation>
    </message>
    <message>
        <source>numbers with “;” between them were expected</source>
        <translation>Zahlen mit „;“ dazwischen wurden erwartet</translation>
    </message>
    <message>
        <source>one of its numbers is impossible</source>
        <translation>eine seiner Zahlen ist unmöglich</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>points of two numbers each were expected</source>
        <translation>Punkte aus je zwei Zahlen wurden erwartet</translation>
    </message>
    <message>
        <source>points were expected</source>
        <translation>Punkte wurden erwartet</translation>
    </message>
    <message>
        <source>property</source>
        <translation>Eigenschaft</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>the bore is longer than the part</source>
        <translation>die Bohrung ist länger als das Teil</translation>
    </message>
    <message>
        <source>the bore is wider than the part</source>
        <translation>die Bohrung ist weiter als das Teil</translation>
    </message>
    <message>
        <source>there are too many</source>
        <translation>es sind zu viele</translation>
    </message>
    <message>
        <source>there are two with this id</source>
        <translation>es gibt zwei mit dieser ID</translation>
    </message>
    <message>
        <source>there is no such choice</source>
        <translation>diese Auswahl gibt es nicht</translation>
    </message>
    <message>
        <source>too many sections, or no list</source>
        <translation>zu viele Abschnitte oder keine Liste</translation>
    </message>
    <message>
        <source>it is of another kind</source>
        <translation>es ist von anderer Art</translation>
    </message>
    <message>
        <source>it gives points without a limit</source>
        <translation>es gibt Punkte ohne Grenze</translation>
    </message>
    <message>
        <source>its tolerance needs the nominal size</source>
        <translation>seine Toleranz braucht das Nennmaß</translation>
    </message>
    <message>
        <source>its tolerance is not a roughness grade, N1 to N12</source>
        <translation>seine Toleranz ist keine Rauheitsklasse N1 bis N12</translation>
    </message>
    <message>
        <source>its figure takes limits, not a tolerance class</source>
        <translation>seine Messgröße hat Grenzen, keine Toleranzklasse</translation>
    </message>
    <message>
        <source>its tolerance class is not known for this size; give limits instead</source>
        <translation>seine Toleranzklasse ist für dieses Maß nicht bekannt; geben Sie Grenzen an</translation>
    </message>
    <message>
        <source>a thread needs a pitch</source>
        <translation>ein Gewinde braucht eine Steigung</translation>
    </message>
    <message>
        <source>a thread is impossible</source>
        <translation>ein Gewinde ist nicht möglich</translation>
    </message>
    <message>
        <source>its upper end is not above the lower one</source>
        <translation>sein oberes Ende liegt nicht über dem unteren</translation>
    </message>
    <message>
        <source>it is beside the part</source>
        <translation>es liegt neben dem Teil</translation>
    </message>
    <message>
        <source>it has more than 500 grooves</source>
        <translation>es hat mehr als 500 Rillen</translation>
    </message>
    <message>
        <source>there is no bore all along it</source>
        <translation>es gibt nicht auf ganzer Länge eine Bohrung</translation>
    </message>
    <message>
        <source>there is no surface</source>
        <translation>es gibt keine Fläche</translation>
    </message>
    <message>
        <source>it is deeper than the part is thick</source>
        <translation>es ist tiefer, als das Teil dick ist</translation>
    </message>
    <message>
        <source>it touches nothing</source>
        <translation>es berührt nichts</translation>
    </message>
    <message>
        <source>the bore is not open at an end of the part</source>
        <translation>die Bohrung ist an keinem Ende des Teils offen</translation>
    </message>
    <message>
        <source>segments of five numbers each were expected</source>
        <translation>Segmente aus je fünf Zahlen wurden erwartet</translation>
    </message>
    <message>
        <source>the part is in several pieces</source>
        <translation>das Teil besteht aus mehreren Stücken</translation>
    </message>
    <message>
        <source>a tool is impossible or not known</source>
        <translation>ein Werkzeug ist unmöglich oder nicht bekannt</translation>
    </message>
    <message>
        <source>a point is too far away</source>
        <translation>ein Punkt ist zu weit entfernt</translation>
    </message>
    <message>
        <source>cutting them would take too long</source>
        <translation>sie zu drehen würde zu lange dauern</translation>
    </message>
    <message>
        <source>names were expected</source>
        <translation>Namen wurden erwartet</translation>
    </message>
    <message>
        <source>start and goal need a number for each joint</source>
        <translation>Start und Ziel brauchen eine Zahl für jedes Gelenk</translation>
    </message>
    <message>
        <source>it has too many joints</source>
        <translation>er hat zu viele Gelenke</translation>
    </message>
    <message>
        <source>a planned joint moves others with it</source>
        <translation>ein geplantes Gelenk bewegt andere mit</translation>
    </message>
    <message>
        <source>a planned joint is not in it</source>
        <translation>ein geplantes Gelenk ist nicht darin</translation>
    </message>
    <message>
        <source>the planned joints are not in order</source>
        <translation>die geplanten Gelenke sind nicht in der Reihenfolge</translation>
    </message>
    <message>
        <source>a joint is geared</source>
        <translation>ein Gelenk ist übersetzt</translation>
    </message>
    <message>
        <source>a degree of freedom moves several joints</source>
        <translation>ein Freiheitsgrad bewegt mehrere Gelenke</translation>
    </message>
    <message>
        <source>its name is impossible</source>
        <translation>sein Name ist unmöglich</translation>
    </message>
    <message>
        <source>its type is not known</source>
        <translation>sein Typ ist nicht bekannt</translation>
    </message>
    <message>
        <source>a number within the limits was expected</source>
        <translation>eine Zahl innerhalb der Grenzen wurde erwartet</translation>
    </message>
    <message>
        <source>1 or -1 was expected</source>
        <translation>1 oder -1 wurde erwartet</translation>
    </message>
    <message>
        <source>mm or m was expected</source>
        <translation>mm oder m wurde erwartet</translation>
    </message>
    <message>
        <source>a length was expected</source>
        <translation>eine Länge wurde erwartet</translation>
    </message>
    <message>
        <source>its name is not unique</source>
        <translation>sein Name ist nicht eindeutig</translation>
    </message>
    <message>
        <source>a list of names was expected</source>
        <translation>eine Liste von Namen wurde erwartet</translation>
    </message>
    <message>
        <source>a number for each joint was expected</source>
        <translation>eine Zahl für jedes Gelenk wurde erwartet</translation>
    </message>
    <message>
        <source>its joints are missing</source>
        <translation>seine Gelenke fehlen</translation>
    </message>
    <message>
        <source>joint or linear was expected</source>
        <translation>joint oder linear wurde erwartet</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>places</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>motions</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>the %1 program</source>
        <translation>das Programm in %1</translation>
    </message>
    <message>
        <source>a name and := were expected</source>
        <translation>ein Name und := wurden erwartet</translation>
    </message>
    <message>
        <source>numbers in brackets were expected</source>
        <translation>Zahlen in Klammern wurden erwartet</translation>
    </message>
    <message>
        <source>there are too many motions</source>
        <translation>es sind zu viele Bewegungen</translation>
    </message>
    <message>
        <source>it is neither numbers nor a name given before</source>
        <translation>es sind weder Zahlen noch ein vorher genannter Name</translation>
    </message>
    <message>
        <source>functions as Offs are not read</source>
        <translation>Funktionen wie Offs werden nicht gelesen</translation>
    </message>
    <message>
        <source>it has too few numbers</source>
        <translation>es hat zu wenige Zahlen</translation>
    </message>
    <message>
        <source>its quaternion has no direction</source>
        <translation>seine Quaternion hat keine Richtung</translation>
    </message>
    <message>
        <source>six axes or X, Y, Z, A, B, C were expected</source>
        <translation>sechs Achsen oder X, Y, Z, A, B, C wurden erwartet</translation>
    </message>
    <message>
        <source>six numbers in brackets were expected</source>
        <translation>sechs Zahlen in Klammern wurden erwartet</translation>
    </message>
    <message>
        <source>P[number] was expected</source>
        <translation>P[Nummer] wurde erwartet</translation>
    </message>
    <message>
        <source>its place is not in /POS, or not all of it</source>
        <translation>sein Punkt steht nicht oder nicht ganz in /POS</translation>
    </message>
    <message>
        <source>a number and a name were expected</source>
        <translation>eine Nummer und ein Name wurden erwartet</translation>
    </message>
    <message>
        <source>a place in another frame than UF : 0</source>
        <translation>ein Punkt in einem anderen Koordinatensystem als UF : 0</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>blend</source>
        <translation>Überschleifen</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>there are too many tools</source>
        <translation>es sind zu viele Werkzeuge</translation>
    </message>
    <message>
        <source>a robot is not in the description</source>
        <translation>ein Roboter steht nicht in der Beschreibung</translation>
    </message>
    <message>
        <source>the robot</source>
        <translation>den Roboter</translation>
    </message>
    <message>
        <source>a cell with several robots as one robot</source>
        <translation>eine Zelle mit mehreren Robotern als ein einzelner Roboter</translation>
    </message>
    <message>
        <source>criterion %1</source>
        <translation>Kriterium %1</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>places of a path</source>
        <translation>Punkte einer Bahn</translation>
    </message>
    <message>
        <source>paths</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>configurations</source>
        <translation>Stellungen</translation>
    </message>
    <message>
        <source>targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>allowed</source>
        <translation>erlaubte Paare</translation>
    </message>
    <message>
        <source>allowed pairs</source>
        <translation>erlaubte Paare</translation>
    </message>
    <message>
        <source>its data are not in the file, or the robot does not hold it</source>
        <translation>seine Daten stehen nicht in der Datei, oder der Roboter hält es nicht</translation>
    </message>
    <message>
        <source>its data are not in the file, or it moves</source>
        <translation>seine Daten stehen nicht in der Datei, oder es bewegt sich</translation>
    </message>
    <message>
        <source>its tool or base is on the controller, not in the file</source>
        <translation>sein Werkzeug oder seine Basis steht in der Steuerung, nicht in der Datei</translation>
    </message>
    <message>
        <source>it is of another tool than those before</source>
        <translation>es gehört zu einem anderen Werkzeug als die davor</translation>
    </message>
    <message>
        <source>CalcRobT has another tool or frame than the motion</source>
        <translation>CalcRobT hat ein anderes Werkzeug oder Koordinatensystem als die Bewegung</translation>
    </message>
    <message>
        <source>routines call each other endlessly</source>
        <translation>Routinen rufen einander endlos auf</translation>
    </message>
    <message>
        <source>%1 of its chunks are lost, or end early</source>
        <translation>%1 seiner Blöcke sind verloren oder enden zu früh</translation>
    </message>
    <message>
        <source>it is no place</source>
        <translation>es ist kein Ort</translation>
    </message>
    <message>
        <source>a saved document as a robot</source>
        <translation>ein gespeichertes Dokument als Roboter</translation>
    </message>
    <message>
        <source>its tolerance class has no letter; give one, as in h10, H10 or js10</source>
        <translation>seine Toleranzklasse hat keinen Buchstaben; geben Sie einen an, wie in h10, H10 oder js10</translation>
    </message>
    <message>
        <source>files in the folder</source>
        <translation>Dateien im Ordner</translation>
    </message>
    <message>
        <source>bytes of DICOM files</source>
        <translation>Bytes in DICOM-Dateien</translation>
    </message>
    <message>
        <source>a data file outside of the folder</source>
        <translation>eine Datendatei außerhalb des Ordners</translation>
    </message>
    <message>
        <source>it is too large</source>
        <translation>sie ist zu groß</translation>
    </message>
    <message>
        <source>it has no grid of floats</source>
        <translation>sie hat kein Gitter aus Gleitkommazahlen</translation>
    </message>
    <message>
        <source>it bounds no material</source>
        <translation>sie begrenzt kein Material</translation>
    </message>
    <message>
        <source>bytes of samples</source>
        <translation>Bytes von Abtastwerten</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Abtastwerte</translation>
    </message>
    <message>
        <source>it has no samples</source>
        <translation>es hat keine Abtastwerte</translation>
    </message>
    <message>
        <source>samples along an axis</source>
        <translation>Abtastwerte entlang einer Achse</translation>
    </message>
    <message>
        <source>it is not finite</source>
        <translation>es ist nicht endlich</translation>
    </message>
    <message>
        <source>the axes lie in one plane</source>
        <translation>die Achsen liegen in einer Ebene</translation>
    </message>
    <message>
        <source>the compressed data end too early</source>
        <translation>die komprimierten Daten enden zu früh</translation>
    </message>
    <message>
        <source>the compressed data are damaged</source>
        <translation>die komprimierten Daten sind beschädigt</translation>
    </message>
    <message>
        <source>there are not as many numbers as it takes</source>
        <translation>es sind nicht so viele Zahlen wie nötig</translation>
    </message>
    <message>
        <source>a MetaImage object other than an image</source>
        <translation>ein anderes MetaImage-Objekt als ein Bild</translation>
    </message>
    <message>
        <source>an image of other than two to four axes</source>
        <translation>ein Bild mit anderen als zwei bis vier Achsen</translation>
    </message>
    <message>
        <source>an image in several data files</source>
        <translation>ein Bild in mehreren Datendateien</translation>
    </message>
    <message>
        <source>an image of colours or complex numbers</source>
        <translation>ein Bild aus Farben oder komplexen Zahlen</translation>
    </message>
    <message>
        <source>an image in a pair of .hdr and .img</source>
        <translation>ein Bild in einem Paar aus .hdr und .img</translation>
    </message>
    <message>
        <source>there is not one for each axis</source>
        <translation>es gibt nicht für jede Achse eine Angabe</translation>
    </message>
    <message>
        <source>a sample of more than 1000 values</source>
        <translation>ein Abtastwert aus mehr als 1000 Werten</translation>
    </message>
    <message>
        <source>an encoding other than raw, gzip or text</source>
        <translation>eine andere Kodierung als raw, gzip oder text</translation>
    </message>
    <message>
        <source>it is not three numbers</source>
        <translation>es sind nicht drei Zahlen</translation>
    </message>
    <message>
        <source>it is not three numbers of samples</source>
        <translation>es sind nicht drei Anzahlen von Abtastwerten</translation>
    </message>
    <message>
        <source>it is not three vectors</source>
        <translation>es sind nicht drei Vektoren</translation>
    </message>
    <message>
        <source>it is neither little nor big</source>
        <translation>es ist weder little noch big</translation>
    </message>
    <message>
        <source>its slices are too far apart</source>
        <translation>ihre Schichten liegen zu weit auseinander</translation>
    </message>
    <message>
        <source>the file contains no image in grey</source>
        <translation>die Datei enthält kein Graustufenbild</translation>
    </message>
    <message>
        <source>its slices do not lie along one line</source>
        <translation>ihre Schichten liegen nicht entlang einer Linie</translation>
    </message>
    <message>
        <source>it is no grid of samples</source>
        <translation>es ist kein Gitter von Abtastwerten</translation>
    </message>
    <message>
        <source>the pixels of a slice cannot be unpacked</source>
        <translation>die Pixel einer Schicht lassen sich nicht entpacken</translation>
    </message>
    <message>
        <source>the size in front of its tolerance is not the nominal size</source>
        <translation>das Maß vor seiner Toleranz ist nicht das Nennmaß</translation>
    </message>
    <message>
        <source>a drill is impossible or not known</source>
        <translation>ein Bohrer ist unmöglich oder unbekannt</translation>
    </message>
    <message>
        <source>a drill was expected, such as ball:6, burr:4 or twist:3</source>
        <translation>ein Bohrer wurde erwartet, zum Beispiel ball:6, burr:4 oder twist:3</translation>
    </message>
    <message>
        <source>a hole has too many poses</source>
        <translation>ein Bohrloch hat zu viele Lagen</translation>
    </message>
    <message>
        <source>a list of holes was expected</source>
        <translation>eine Liste von Bohrlöchern wurde erwartet</translation>
    </message>
    <message>
        <source>a pose of the drill is impossible</source>
        <translation>eine Lage des Bohrers ist unmöglich</translation>
    </message>
    <message>
        <source>balls were expected: x; y; z; radius, with “|” between them</source>
        <translation>Kugeln wurden erwartet: x; y; z; Radius, mit „|“ dazwischen</translation>
    </message>
    <message>
        <source>figures of drilling have limits, no tolerance</source>
        <translation>Messgrößen des Bohrens haben Grenzen, keine Toleranz</translation>
    </message>
    <message>
        <source>it is no drill</source>
        <translation>es ist kein Bohrer</translation>
    </message>
    <message>
        <source>points were expected: time, depth, beside, across, in order of time</source>
        <translation>Punkte wurden erwartet: Zeit, Tiefe, seitlich, quer, nach der Zeit geordnet</translation>
    </message>
    <message>
        <source>poses of the drill are lost</source>
        <translation>Lagen des Bohrers sind verloren</translation>
    </message>
    <message>
        <source>three lengths were expected, with “;” between them</source>
        <translation>drei Längen wurden erwartet, mit „;“ dazwischen</translation>
    </message>
    <message>
        <source>three numbers were expected, with “;” between them</source>
        <translation>drei Zahlen wurden erwartet, mit „;“ dazwischen</translation>
    </message>
    <message>
        <source>its voxels are not cubes along the axes</source>
        <translation>ihre Voxel sind keine Würfel entlang der Achsen</translation>
    </message>
    <message>
        <source>it is not a scale factor</source>
        <translation>es ist kein Skalierungsfaktor</translation>
    </message>
    <message>
        <source>it is not a distance of samples</source>
        <translation>es ist kein Abstand von Abtastwerten</translation>
    </message>
    <message>
        <source>one is not a number of samples</source>
        <translation>eine Angabe ist keine Anzahl von Abtastwerten</translation>
    </message>
    <message>
        <source>it is not a type of numbers</source>
        <translation>es ist kein Zahlentyp</translation>
    </message>
    <message>
        <source>it is not a number of values</source>
        <translation>es ist keine Anzahl von Werten</translation>
    </message>
    <message>
        <source>it is more than the file contains</source>
        <translation>es ist mehr, als die Datei enthält</translation>
    </message>
    <message>
        <source>it is not a number of axes</source>
        <translation>es ist keine Anzahl von Achsen</translation>
    </message>
    <message>
        <source>it is not a position after the header</source>
        <translation>es ist keine Position nach dem Dateikopf</translation>
    </message>
    <message>
        <source>one is not a vector in space</source>
        <translation>eine Angabe ist kein Vektor im Raum</translation>
    </message>
    <message>
        <source>it is not a number of lines</source>
        <translation>es ist keine Anzahl von Zeilen</translation>
    </message>
    <message>
        <source>it is not a number</source>
        <translation>es ist keine Zahl</translation>
    </message>
    <message>
        <source>it is not a grid of samples</source>
        <translation>es ist kein Gitter von Abtastwerten</translation>
    </message>
    <message>
        <source>%1 of its samples are lost</source>
        <translation>%1 ihrer Abtastwerte sind verloren</translation>
    </message>
    <message>
        <source>its samples are lost</source>
        <translation>ihre Abtastwerte sind verloren</translation>
    </message>
    <message>
        <source>it is no range of values</source>
        <translation>es ist kein Wertebereich</translation>
    </message>
    <message>
        <source>part of what was painted is lost</source>
        <translation>ein Teil des Gemalten ist verloren</translation>
    </message>
    <message>
        <source>full and empty blocks have no surface between them</source>
        <translation>zwischen vollen und leeren Blöcken liegt keine Oberfläche</translation>
    </message>
    <message>
        <source>it is not a number of chunks</source>
        <translation>es ist keine Anzahl von Blöcken</translation>
    </message>
    <message>
        <source>it is not the size of a voxel</source>
        <translation>es ist nicht die Größe eines Voxels</translation>
    </message>
    <message>
        <source>its code is not a number</source>
        <translation>sein Code ist keine Zahl</translation>
    </message>
    <message>
        <source>one of them is not a box, cylinder or sphere</source>
        <translation>eines davon ist weder Quader noch Zylinder noch Kugel</translation>
    </message>
    <message>
        <source>the tip is not connected to the base</source>
        <translation>die Spitze ist nicht mit der Basis verbunden</translation>
    </message>
    <message>
        <source>the z of the points is not ascending</source>
        <translation>die Z-Werte der Punkte sind nicht aufsteigend</translation>
    </message>
    <message>
        <source>it refers to a criterion that does not exist</source>
        <translation>es verweist auf ein Kriterium, das es nicht gibt</translation>
    </message>
    <message>
        <source>its lists differ in length, or are not ascending</source>
        <translation>seine Listen sind verschieden lang oder nicht aufsteigend</translation>
    </message>
    <message>
        <source>it does not specify which routine is the first</source>
        <translation>es ist nicht angegeben, welche Routine die erste ist</translation>
    </message>
    <message>
        <source>its class needs the thread in front of it, as in M20x2.5-6g</source>
        <translation>Die Toleranzklasse braucht das Gewinde davor, wie in M20x2.5-6g</translation>
    </message>
    <message>
        <source>its tolerance is not that of a thread, as M20x2.5-6g or M20-6H</source>
        <translation>Die Toleranz ist nicht die eines Gewindes, wie M20x2.5-6g oder M20-6H</translation>
    </message>
    <message>
        <source>its sides are not known</source>
        <translation>Die Seiten sind unbekannt</translation>
    </message>
    <message>
        <source>it is not a list of holes</source>
        <translation>es ist keine Liste von Bohrlöchern</translation>
    </message>
    <message>
        <source>it is not a volume</source>
        <translation>es ist kein Volumen</translation>
    </message>
    <message>
        <source>its samples need more memory than there is</source>
        <translation>ihre Abtastwerte brauchen mehr Arbeitsspeicher, als vorhanden ist</translation>
    </message>
    <message>
        <source>bytes of the data file</source>
        <translation>Bytes der Datendatei</translation>
    </message>
    <message>
        <source>bytes of the unpacked image</source>
        <translation>Bytes des entpackten Bildes</translation>
    </message>
    <message>
        <source>bytes of a picture</source>
        <translation>Bytes eines Bildes</translation>
    </message>
    <message>
        <source>pixels of a picture</source>
        <translation>Bildpunkte eines Bildes</translation>
    </message>
    <message>
        <source>the robot reaches its place in no way with these S and T</source>
        <translation>mit diesen Werten von S und T erreicht der Roboter die Stelle auf keine Weise</translation>
    </message>
    <message>
        <source>it is not YAML</source>
        <translation>es ist kein YAML</translation>
    </message>
    <message>
        <source>there are none, or more than %1</source>
        <translation>es gibt keine, oder mehr als %1</translation>
    </message>
    <message>
        <source>a joint of the goal is missing</source>
        <translation>ein Gelenk des Ziels fehlt</translation>
    </message>
    <message>
        <source>a position for each name was expected</source>
        <translation>eine Stellung für jeden Namen wurde erwartet</translation>
    </message>
    <message>
        <source>one goal with joint_constraints, and nothing else, was expected</source>
        <translation>ein Ziel mit joint_constraints und nichts sonst wurde erwartet</translation>
    </message>
    <message>
        <source>a square of true and false was expected</source>
        <translation>ein Quadrat aus true und false wurde erwartet</translation>
    </message>
    <message>
        <source>they are not supported</source>
        <translation>sie werden nicht unterstützt</translation>
    </message>
    <message>
        <source>it is not supported</source>
        <translation>es wird nicht unterstützt</translation>
    </message>
    <message>
        <source>the frame</source>
        <translation>das Bezugssystem</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bezugssysteme</translation>
    </message>
    <message>
        <source>the volume was changed without them</source>
        <translation>das Volumen wurde ohne sie geändert</translation>
    </message>
    <message>
        <source>the robot reaches its place in no way with this configuration</source>
        <translation>der Roboter erreicht die Stelle mit dieser Konfiguration auf keine Weise</translation>
    </message>
    <message>
        <source>it is not a list of tries</source>
        <translation>es ist keine Liste von Versuchen</translation>
    </message>
    <message>
        <source>a try is impossible</source>
        <translation>ein Versuch ist unmöglich</translation>
    </message>
    <message>
        <source>the bottom of its bore is neither flat nor the cone of a drill of 118°</source>
        <translation>der Boden ihrer Bohrung ist weder eben noch der Kegel eines Bohrers von 118°</translation>
    </message>
    <message>
        <source>Draw one of these, or write a program of your own.</source>
        <translation>Zeichnen Sie eines davon, oder schreiben Sie ein eigenes Programm.</translation>
    </message>
    <message>
        <source>the picture could not be rendered</source>
        <translation>das Bild konnte nicht gezeichnet werden</translation>
    </message>
    <message>
        <source>its shape is not missing</source>
        <translation>seine Form fehlt nicht</translation>
    </message>
    <message>
        <source>a list of lines was expected</source>
        <translation>eine Liste von Zeilen wurde erwartet</translation>
    </message>
    <message>
        <source>the tool turns by more than half a turn along the arc: divide it into two</source>
        <translation>das Werkzeug dreht sich entlang des Bogens um mehr als eine halbe Umdrehung: Teilen Sie ihn in zwei</translation>
    </message>
    <message>
        <source>functions but Offs and RelTool are not read</source>
        <translation>andere Funktionen als Offs und RelTool werden nicht gelesen</translation>
    </message>
    <message>
        <source>a target and three numbers were expected</source>
        <translation>ein Ziel und drei Zahlen wurden erwartet</translation>
    </message>
    <message>
        <source>its displacement is neither a number nor a CONST num of the module</source>
        <translation>seine Verschiebung ist weder eine Zahl noch ein CONST num des Moduls</translation>
    </message>
    <message>
        <source>a place on the arc was expected</source>
        <translation>eine Stelle auf dem Bogen wurde erwartet</translation>
    </message>
    <message>
        <source>the start of the arc is not known</source>
        <translation>der Anfang des Bogens ist nicht bekannt</translation>
    </message>
    <message>
        <source>the three places of the arc are in a line</source>
        <translation>die drei Stellen des Bogens liegen auf einer Geraden</translation>
    </message>
    <message>
        <source>the arc is longer than half a circle: divide it into two</source>
        <translation>der Bogen ist länger als ein Halbkreis: Teilen Sie ihn in zwei</translation>
    </message>
    <message>
        <source>it is neither numbers nor a variable that was given numbers before</source>
        <translation>es sind weder Zahlen noch eine Variable, die zuvor Zahlen bekam</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>an external axis moves, and only axes of the robot can</source>
        <translation>eine Zusatzachse bewegt sich, und nur Achsen des Roboters können das</translation>
    </message>
    <message>
        <source>there are too many without a motion</source>
        <translation>es sind zu viele ohne eine Bewegung</translation>
    </message>
    <message>
        <source>too many functions are within each other</source>
        <translation>zu viele Funktionen stehen ineinander</translation>
    </message>
    <message>
        <source>two routines have the name that it calls</source>
        <translation>zwei Routinen haben den Namen, den es aufruft</translation>
    </message>
    <message>
        <source>it is in /POS twice</source>
        <translation>er steht zweimal in /POS</translation>
    </message>
    <message>
        <source>its slices have neither positions nor a stated distance</source>
        <translation>seine Schichten haben weder Positionen noch einen angegebenen Abstand</translation>
    </message>
    <message>
        <source>it has too many slices</source>
        <translation>es hat zu viele Schichten</translation>
    </message>
    <message>
        <source>its frame or tool is not the selected one</source>
        <translation>sein Koordinatensystem oder Werkzeug ist nicht das gewählte</translation>
    </message>
    <message>
        <source>it holds contours of regions (an RT structure set), not an image</source>
        <translation>sie enthält Umrisse von Bereichen (ein RT Structure Set), kein Bild</translation>
    </message>
    <message>
        <source>it holds a colour image, not one in grey</source>
        <translation>sie enthält ein Farbbild, kein Graustufenbild</translation>
    </message>
    <message>
        <source>its segments have slices with uneven distances</source>
        <translation>ihre Segmente haben Schichten mit ungleichen Abständen</translation>
    </message>
    <message>
        <source>its segments have no positions</source>
        <translation>ihre Segmente haben keine Positionen</translation>
    </message>
    <message>
        <source>it holds a plan, a report or another object without an image</source>
        <translation>sie enthält einen Plan, einen Bericht oder ein anderes Objekt ohne Bild</translation>
    </message>
</context>
<context>
    <name>Exercise</name>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>A ball of 36 mm on a neck of 12 mm.</source>
        <translation>Eine Kugel von 36 mm auf einem Hals von 12 mm.</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Schruppen</translation>
    </message>
    <message>
        <source>Take the material off in passes of 1.5 mm and leave 0.4 mm on the radius.</source>
        <translation>Nehmen Sie den Werkstoff mit 1,5 mm Zustellung je Schnitt ab, und lassen Sie 0,4 mm Aufmaß im Radius stehen.</translation>
    </message>
    <message>
        <source>Begin each pass in the air at the end of the bar.</source>
        <translation>Beginnen Sie jeden Schnitt in der Luft am Ende der Stange.</translation>
    </message>
    <message>
        <source>The read-out shows the diameter: 0.4 mm on the radius are 0.8 mm on the diameter.</source>
        <translation>Die Anzeige zeigt den Durchmesser: 0,4 mm im Radius sind 0,8 mm im Durchmesser.</translation>
    </message>
    <message>
        <source>Move both slides at once along the circle.</source>
        <translation>Bewegen Sie beide Schlitten gleichzeitig entlang des Kreises.</translation>
    </message>
    <message>
        <source>Begin at the pole, where the ball ends, and go towards the chuck.</source>
        <translation>Beginnen Sie am Pol, wo die Kugel endet, und fahren Sie zum Futter hin.</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Schlichten</translation>
    </message>
    <message>
        <source>Follow the outline in one pass at 0.1 mm per revolution.</source>
        <translation>Fahren Sie den Umriss in einem Schnitt mit 0,1 mm je Umdrehung ab.</translation>
    </message>
    <message>
        <source>The slower the feed, the finer the surface.</source>
        <translation>Je kleiner der Vorschub, desto feiner die Oberfläche.</translation>
    </message>
    <message>
        <source>Form within 0.1 mm</source>
        <translation>Form auf 0,1 mm genau</translation>
    </message>
    <message>
        <source>Radius 18 ±0.1</source>
        <translation>Radius 18 ±0,1</translation>
    </message>
    <message>
        <source>Finish N8</source>
        <translation>Rauheit N8</translation>
    </message>
    <message>
        <source>No collision, no feed too high</source>
        <translation>Keine Kollision, kein zu hoher Vorschub</translation>
    </message>
    <message>
        <source>Cutting force within that of the lathe</source>
        <translation>Schnittkraft in den Grenzen der Drehmaschine</translation>
    </message>
    <message>
        <source>Power within that of the motor</source>
        <translation>Leistung in den Grenzen des Motors</translation>
    </message>
    <message>
        <source>In the time</source>
        <translation>In der vorgegebenen Zeit</translation>
    </message>
    <message>
        <source>Without many hints</source>
        <translation>Ohne viele Hinweise</translation>
    </message>
    <message>
        <source>Bored bush</source>
        <translation>Buchse mit Bohrung</translation>
    </message>
    <message>
        <source>A bush with a bore to H10.</source>
        <translation>Eine Buchse mit einer Bohrung nach H10.</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Außendrehen</translation>
    </message>
    <message>
        <source>Turn ⌀44 over 30 mm.</source>
        <translation>Drehen Sie ⌀44 auf 30 mm Länge.</translation>
    </message>
    <message>
        <source>Bore</source>
        <translation>Bohrung ausdrehen</translation>
    </message>
    <message>
        <source>Bore in passes of 1.5 mm to 0.4 mm below the size.</source>
        <translation>Drehen Sie die Bohrung mit 1,5 mm Zustellung je Schnitt bis 0,4 mm unter Maß aus.</translation>
    </message>
    <message>
        <source>The bore has no chips to see: listen.</source>
        <translation>In der Bohrung sind keine Späne zu sehen: Hören Sie hin.</translation>
    </message>
    <message>
        <source>Finish the bore</source>
        <translation>Bohrung schlichten</translation>
    </message>
    <message>
        <source>One pass at 0.1 mm per revolution.</source>
        <translation>Ein Schnitt mit 0,1 mm je Umdrehung.</translation>
    </message>
    <message>
        <source>⌀25 H10 bore</source>
        <translation>Bohrung ⌀25 H10</translation>
    </message>
    <message>
        <source>Depth 28 ±0.2</source>
        <translation>Tiefe 28 ±0,2</translation>
    </message>
    <message>
        <source>Dumb-bell weight</source>
        <translation>Hantelgewicht</translation>
    </message>
    <message>
        <source>Two equal heads with a handle between them.</source>
        <translation>Zwei gleiche Köpfe mit einem Griff dazwischen.</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>Turn the handle between the two heads.</source>
        <translation>Drehen Sie den Griff zwischen den beiden Köpfen.</translation>
    </message>
    <message>
        <source>The faces of the heads are 34 mm apart.</source>
        <translation>Die Planflächen der Köpfe haben 34 mm Abstand.</translation>
    </message>
    <message>
        <source>Handle 34 ±0.2</source>
        <translation>Griff 34 ±0,2</translation>
    </message>
    <message>
        <source>Your first shoulder</source>
        <translation>Ihr erster Absatz</translation>
    </message>
    <message>
        <source>Turn the end of a bar of 40 mm down to 30 mm, over a length of 30 mm. It takes a few minutes.</source>
        <translation>Drehen Sie eine Stange von ⌀40 mm am Ende auf ⌀30 mm ab, über eine Länge von 30 mm. Das dauert einige Minuten.</translation>
    </message>
    <message>
        <source>Choose the tool</source>
        <translation>Werkzeug wählen</translation>
    </message>
    <message>
        <source>Press V, or choose “Turn” above. A round tool appears at the pointer; the grey bar turns all the time, so only the distance from its axis matters.</source>
        <translation>Drücken Sie V, oder wählen Sie oben „Drehen“. Am Zeiger erscheint ein rundes Werkzeug; die graue Stange dreht sich die ganze Zeit, daher zählt nur der Abstand von ihrer Achse.</translation>
    </message>
    <message>
        <source>First pass</source>
        <translation>Erster Schnitt</translation>
    </message>
    <message>
        <source>Go with the pointer to the right end of the bar, just inside its edge. Hold the left button, and drag slowly along the bar over 30 mm. The label shows the diameter ⌀ that is left, and the feed f: more than 1 mm per revolution, 13 mm a second, is too fast; below 0.25 mm the surface becomes fine.</source>
        <translation>Gehen Sie mit dem Zeiger an das rechte Ende der Stange, knapp innerhalb ihres Randes. Halten Sie die linke Taste, und ziehen Sie langsam 30 mm an der Stange entlang. Die Anzeige am Zeiger nennt den Durchmesser ⌀, der übrig bleibt, und den Vorschub f: Mehr als 1 mm je Umdrehung, 13 mm in der Sekunde, ist zu schnell; unter 0,25 mm wird die Oberfläche fein.</translation>
    </message>
    <message>
        <source>Nothing is cut while the tool is outside of the bar. Begin beyond its end and come in slowly.</source>
        <translation>Solange das Werkzeug außerhalb der Stange ist, wird nichts geschnitten. Beginnen Sie jenseits ihres Endes, und fahren Sie langsam hinein.</translation>
    </message>
    <message>
        <source>Ctrl+Z takes a pass back.</source>
        <translation>Strg+Z nimmt einen Schnitt zurück.</translation>
    </message>
    <message>
        <source>Go deeper</source>
        <translation>Tiefer zustellen</translation>
    </message>
    <message>
        <source>Repeat it a little deeper each time, until the label shows ⌀30.</source>
        <translation>Wiederholen Sie das jedes Mal ein wenig tiefer, bis die Anzeige am Zeiger ⌀30 nennt.</translation>
    </message>
    <message>
        <source>Two or three passes are enough.</source>
        <translation>Zwei oder drei Schnitte genügen.</translation>
    </message>
    <message>
        <source>The shoulder</source>
        <translation>Der Absatz</translation>
    </message>
    <message>
        <source>Let the pass end 30 mm from the end, so that a face stands there.</source>
        <translation>Beenden Sie den Schnitt 30 mm vom Ende der Stange, sodass dort eine Planfläche steht.</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Press “Measure” below. Lines with ✓ are right; with ✗, take another pass.</source>
        <translation>Drücken Sie unten „Messen“. Zeilen mit ✓ stimmen; bei ✗ machen Sie noch einen Schnitt.</translation>
    </message>
    <message>
        <source>Length 30 ±1</source>
        <translation>Länge 30 ±1</translation>
    </message>
    <message>
        <source>Gourd</source>
        <translation>Kalebasse</translation>
    </message>
    <message>
        <source>Two bulbs with a waist, by hand and eye.</source>
        <translation>Zwei Bäuche mit einer Taille, nach Gefühl und Augenmaß.</translation>
    </message>
    <message>
        <source>Waist</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Find the narrowest place, 36 mm from the end.</source>
        <translation>Suchen Sie die dünnste Stelle, 36 mm vom Ende.</translation>
    </message>
    <message>
        <source>Plunge a little, measure, and plunge again.</source>
        <translation>Stechen Sie ein wenig ein, messen Sie, und stechen Sie weiter ein.</translation>
    </message>
    <message>
        <source>Form within 0.15 mm</source>
        <translation>Form auf 0,15 mm genau</translation>
    </message>
    <message>
        <source>Shaft with shoulders</source>
        <translation>Welle mit Absätzen</translation>
    </message>
    <message>
        <source>Three diameters to h10 with exact lengths.</source>
        <translation>Drei Durchmesser nach h10 mit genauen Längen.</translation>
    </message>
    <message>
        <source>First shoulder</source>
        <translation>Erster Absatz</translation>
    </message>
    <message>
        <source>Turn ⌀20 over 30 mm.</source>
        <translation>Drehen Sie ⌀20 auf 30 mm Länge.</translation>
    </message>
    <message>
        <source>Touch off at the end first.</source>
        <translation>Kratzen Sie zuerst am Ende der Stange an.</translation>
    </message>
    <message>
        <source>Second shoulder</source>
        <translation>Zweiter Absatz</translation>
    </message>
    <message>
        <source>Turn ⌀28 over the next 30 mm.</source>
        <translation>Drehen Sie ⌀28 auf den nächsten 30 mm.</translation>
    </message>
    <message>
        <source>Third shoulder</source>
        <translation>Dritter Absatz</translation>
    </message>
    <message>
        <source>Turn ⌀36 over 25 mm.</source>
        <translation>Drehen Sie ⌀36 auf 25 mm Länge.</translation>
    </message>
    <message>
        <source>Length 30 ±0.1</source>
        <translation>Länge 30 ±0,1</translation>
    </message>
    <message>
        <source>Thread M20</source>
        <translation>Gewinde M20</translation>
    </message>
    <message>
        <source>A thread M20 × 2.5 - 6g with relief and chamfer.</source>
        <translation>Ein Gewinde M20 × 2,5 - 6g mit Freistich und Fase.</translation>
    </message>
    <message>
        <source>Major diameter</source>
        <translation>Außendurchmesser</translation>
    </message>
    <message>
        <source>Turn to 19.8 mm, as a thread M20 with a pitch of 2.5 mm begins.</source>
        <translation>Drehen Sie auf ⌀19,8 mm, das Ausgangsmaß für ein Gewinde M20 mit 2,5 mm Steigung.</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Freistich</translation>
    </message>
    <message>
        <source>Groove to 16.4 mm beside the collar, where the thread runs out.</source>
        <translation>Stechen Sie neben dem Bund, wo das Gewinde ausläuft, auf ⌀16,4 mm ein.</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Gewinde</translation>
    </message>
    <message>
        <source>Cut the thread with the tool of 60°: passes of falling depth, down to a pitch diameter of 18.25 mm.</source>
        <translation>Drehen Sie das Gewinde mit dem Gewindedrehmeißel von 60°: Schnitte mit abnehmender Zustellung, bis zu einem Flankendurchmesser von 18,25 mm.</translation>
    </message>
    <message>
        <source>On the lathe, set the pitch and close the half-nut in front of the end of the bar; open it in the relief.</source>
        <translation>Stellen Sie an der Drehmaschine die Steigung ein, und schließen Sie die Schlossmutter vor dem Ende der Stange; öffnen Sie sie im Freistich.</translation>
    </message>
    <message>
        <source>A lead that is a part of the lead screw&apos;s pitch always finds its groove again.</source>
        <translation>Eine Steigung, die in der Steigung der Leitspindel ohne Rest aufgeht, trifft immer wieder ihre Rille.</translation>
    </message>
    <message>
        <source>⌀20 6g major diameter</source>
        <translation>Außendurchmesser ⌀20 6g</translation>
    </message>
    <message>
        <source>Pitch 2.5 ±0.02</source>
        <translation>Steigung 2,5 ±0,02</translation>
    </message>
    <message>
        <source>Pitch diameter 18.376 6g</source>
        <translation>Flankendurchmesser 18,376 6g</translation>
    </message>
    <message>
        <source>Minor diameter 6g</source>
        <translation>Kerndurchmesser 6g</translation>
    </message>
    <message>
        <source>To the collar 40 ±0.2</source>
        <translation>Bis zum Bund 40 ±0,2</translation>
    </message>
    <message>
        <source>Chamfer 45°</source>
        <translation>Fase 45°</translation>
    </message>
    <message>
        <source>Wine glass</source>
        <translation>Weinglas</translation>
    </message>
    <message>
        <source>A glass with a hollow bowl on a thin stem.</source>
        <translation>Ein Glas mit hohlem Kelch auf einem dünnen Stiel.</translation>
    </message>
    <message>
        <source>Hollow the bowl</source>
        <translation>Kelch ausdrehen</translation>
    </message>
    <message>
        <source>Bore from the end in passes of 1.5 mm, while the stem is still thick.</source>
        <translation>Drehen Sie vom Ende her mit 1,5 mm Zustellung je Schnitt aus, solange der Stiel noch dick ist.</translation>
    </message>
    <message>
        <source>What is hollowed last breaks the stem.</source>
        <translation>Wer den Kelch zuletzt ausdreht, bricht den Stiel ab.</translation>
    </message>
    <message>
        <source>Stem</source>
        <translation>Stiel</translation>
    </message>
    <message>
        <source>Turn the stem to 8 mm.</source>
        <translation>Drehen Sie den Stiel auf ⌀8 mm.</translation>
    </message>
    <message>
        <source>Small cuts: the stem bends.</source>
        <translation>Kleine Schnitte: Der Stiel biegt sich.</translation>
    </message>
    <message>
        <source>Depth of the bowl 39 ±0.5</source>
        <translation>Tiefe des Kelchs 39 ±0,5</translation>
    </message>
    <message>
        <source>turning tool</source>
        <translation>Drehmeißel</translation>
    </message>
    <message>
        <source>Burr hole in the skull</source>
        <translation>Bohrloch im Schädel</translation>
    </message>
    <message>
        <source>Drill through the skull along the planned path, and stop before the brain.</source>
        <translation>Bohren Sie entlang der geplanten Bahn durch den Schädel, und halten Sie vor dem Gehirn an.</translation>
    </message>
    <message>
        <source>Choose the drill</source>
        <translation>Bohrer wählen</translation>
    </message>
    <message>
        <source>Press Shift+D, or choose “Drill” above. Drill, speed and material are those of the exercise. The green rod shows the planned path.</source>
        <translation>Drücken Sie Umschalt+D, oder wählen Sie oben „Bohren“. Bohrer, Drehzahl und Material gibt die Übung vor. Der grüne Stab zeigt die geplante Bahn.</translation>
    </message>
    <message>
        <source>Find the place</source>
        <translation>Stelle finden</translation>
    </message>
    <message>
        <source>Go with the pointer to where the green rod meets the skull. The circle shows the drill.</source>
        <translation>Gehen Sie mit dem Zeiger dorthin, wo der grüne Stab auf den Schädel trifft. Der Kreis zeigt den Bohrer.</translation>
    </message>
    <message>
        <source>Turn the view until you look along the rod.</source>
        <translation>Drehen Sie die Ansicht, bis Sie entlang des Stabs blicken.</translation>
    </message>
    <message>
        <source>With Shift held, the drill goes straight along the view.</source>
        <translation>Bei gehaltener Umschalttaste geht der Bohrer gerade in Blickrichtung.</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>Hold the left button: the drill goes on at its feed, and the plots show thrust and torque. Let go as soon as the breakthrough is shown.</source>
        <translation>Halten Sie die linke Taste: Der Bohrer geht mit seinem Vorschub voran, und die Diagramme zeigen Vorschubkraft und Drehmoment. Lassen Sie los, sobald der Durchbruch angezeigt wird.</translation>
    </message>
    <message>
        <source>The thrust falls when the tip comes through the inner table.</source>
        <translation>Die Vorschubkraft fällt, wenn die Spitze durch die Tabula interna kommt.</translation>
    </message>
    <message>
        <source>Ctrl+Z takes a hole back, and with it all that was measured of it.</source>
        <translation>Strg+Z nimmt ein Bohrloch zurück, und mit ihm alles, was daran gemessen wurde.</translation>
    </message>
    <message>
        <source>Measure the hole</source>
        <translation>Bohrloch messen</translation>
    </message>
    <message>
        <source>Press “Measure” below.</source>
        <translation>Drücken Sie unten „Messen“.</translation>
    </message>
    <message>
        <source>The brain is not touched</source>
        <translation>Das Gehirn ist nicht berührt</translation>
    </message>
    <message>
        <source>Stopped within 2 mm</source>
        <translation>Innerhalb von 2 mm angehalten</translation>
    </message>
    <message>
        <source>On the planned path</source>
        <translation>Auf der geplanten Bahn</translation>
    </message>
    <message>
        <source>Through within 20 s</source>
        <translation>Durch in höchstens 20 s</translation>
    </message>
    <message>
        <source>Thrust below 30 N</source>
        <translation>Vorschubkraft unter 30 N</translation>
    </message>
    <message>
        <source>Gentle in the last millimetre</source>
        <translation>Behutsam auf dem letzten Millimeter</translation>
    </message>
    <message>
        <source>Torque below 150 N·mm</source>
        <translation>Drehmoment unter 150 N·mm</translation>
    </message>
    <message>
        <source>Cool drilling</source>
        <translation>Kühl gebohrt</translation>
    </message>
    <message>
        <source>Part off</source>
        <translation>Abstechen</translation>
    </message>
    <message>
        <source>Part the glass off below its foot.</source>
        <translation>Das Glas unterhalb seines Fußes abstechen.</translation>
    </message>
    <message>
        <source>Straight in to the axis, at a small feed.</source>
        <translation>Gerade bis zur Achse einstechen, mit kleinem Vorschub.</translation>
    </message>
    <message>
        <source>boring bar</source>
        <translation>Innendrehmeißel</translation>
    </message>
    <message>
        <source>parting tool</source>
        <translation>Abstechmeißel</translation>
    </message>
    <message>
        <source>threading tool of 60°</source>
        <translation>Gewindedrehmeißel von 60°</translation>
    </message>
    <message>
        <source>On the lathe, drill first: a boring bar needs a hole to begin in.</source>
        <translation>Bohren Sie auf der Drehmaschine zuerst: Ein Innendrehmeißel braucht ein Loch, in dem er beginnt.</translation>
    </message>
    <message>
        <source>Z in the label is the place of the face that the tool leaves, from the finished end of the bar: stop at Z -30.</source>
        <translation>Z in der Anzeige am Zeiger ist der Ort der Planfläche, die das Werkzeug hinterlässt, vom fertigen Ende der Stange aus: Halten Sie bei Z -30 an.</translation>
    </message>
</context>
<context>
    <name>ExpressionText</name>
    <message>
        <source>A number is missing</source>
        <translation>Es fehlt eine Zahl</translation>
    </message>
    <message>
        <source>A number is missing at the end</source>
        <translation>Am Ende fehlt eine Zahl</translation>
    </message>
    <message>
        <source>A number is missing before “%1”</source>
        <translation>Vor „%1“ fehlt eine Zahl</translation>
    </message>
    <message>
        <source>A closing bracket is missing at the end</source>
        <translation>Am Ende fehlt eine schließende Klammer</translation>
    </message>
    <message>
        <source>A closing bracket is missing before “%1”</source>
        <translation>Vor „%1“ fehlt eine schließende Klammer</translation>
    </message>
    <message>
        <source>“%1” is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>“%1” can be read in two ways; write it with a point, or without the comma</source>
        <translation>„%1“ ist mehrdeutig; schreiben Sie es mit Punkt oder ohne Komma</translation>
    </message>
    <message>
        <source>Lengths, angles and plain numbers cannot be added to each other</source>
        <translation>Längen, Winkel und reine Zahlen lassen sich nicht addieren</translation>
    </message>
    <message>
        <source>The result has the wrong unit</source>
        <translation>Das Ergebnis hat die falsche Einheit</translation>
    </message>
    <message>
        <source>The result is too large</source>
        <translation>Das Ergebnis ist zu groß</translation>
    </message>
    <message>
        <source>%1 (character %2).</source>
        <translation>%1 (Zeichen %2).</translation>
    </message>
    <message>
        <source>The expression is too long</source>
        <translation>Der Ausdruck ist zu lang</translation>
    </message>
    <message>
        <source>The brackets are nested too deeply</source>
        <translation>Die Klammern sind zu tief verschachtelt</translation>
    </message>
    <message>
        <source>An operator such as + or * is missing before “%1”</source>
        <translation>Vor „%1“ fehlt ein Operator wie + oder *</translation>
    </message>
    <message>
        <source>“%1” is not a known unit</source>
        <translation>„%1“ ist keine bekannte Einheit</translation>
    </message>
    <message>
        <source>Division by zero</source>
        <translation>Division durch null</translation>
    </message>
</context>
<context>
    <name>FaceMateTool</name>
    <message>
        <source>Lay %1 on a face</source>
        <translation>%1 auf eine Fläche legen</translation>
    </message>
</context>
<context>
    <name>Fidelity</name>
    <message>
        <source>share of the diagonal</source>
        <translation>Anteil der Diagonale</translation>
    </message>
    <message>
        <source>Method that fills holes</source>
        <translation>Verfahren, das Löcher füllt</translation>
    </message>
    <message>
        <source>ear</source>
        <translation>Ohren</translation>
    </message>
    <message>
        <source>minimal</source>
        <translation>minimal</translation>
    </message>
    <message>
        <source>refined</source>
        <translation>verfeinert</translation>
    </message>
    <message>
        <source>fair</source>
        <translation>glatt</translation>
    </message>
    <message>
        <source>RMS distance of the patch from the surface</source>
        <translation>mittlerer Abstand (RMS) der Füllfläche von der Fläche</translation>
    </message>
    <message>
        <source>% of the hole</source>
        <translation>% des Lochs</translation>
    </message>
    <message>
        <source>CPU time of a fill</source>
        <translation>CPU-Zeit einer Füllung</translation>
    </message>
    <message>
        <source>memory of an undo step</source>
        <translation>Speicher eines Rückgängig-Schritts</translation>
    </message>
    <message>
        <source>CPU time to take, undo and redo a step</source>
        <translation>CPU-Zeit, um einen Schritt zu tun, zurückzunehmen und zu wiederholen</translation>
    </message>
    <message>
        <source>draw calls of a frame</source>
        <translation>Zeichenaufrufe eines Bildes</translation>
    </message>
    <message>
        <source>calls</source>
        <translation>Aufrufe</translation>
    </message>
    <message>
        <source>largest distance of the triangles from the surface</source>
        <translation>größter Abstand der Dreiecke von der Fläche</translation>
    </message>
    <message>
        <source>CPU time of a tessellation</source>
        <translation>CPU-Zeit einer Triangulierung</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>dihedral</source>
        <translation>Knick</translation>
    </message>
    <message>
        <source>ridge</source>
        <translation>Grate</translation>
    </message>
    <message>
        <source>Edges of a hole that is filled in one piece</source>
        <translation>Kanten eines Lochs, das in einem Stück gefüllt wird</translation>
    </message>
    <message>
        <source>Triangles that a slow display draws while the view moves</source>
        <translation>Dreiecke, die eine langsame Anzeige zeichnet, während sich die Ansicht bewegt</translation>
    </message>
    <message>
        <source>largest distance from the mesh, in diagonals</source>
        <translation>größter Abstand vom Netz, in Diagonalen</translation>
    </message>
    <message>
        <source>triangles of a frame</source>
        <translation>Dreiecke eines Bildes</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Sides of the round shapes of robots</source>
        <translation>Seiten der runden Formen von Robotern</translation>
    </message>
    <message>
        <source>largest distance of the triangles from the shape, in radii</source>
        <translation>größter Abstand der Dreiecke von der Form, in Radien</translation>
    </message>
    <message>
        <source>triangles of a shape</source>
        <translation>Dreiecke einer Form</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>tangent</source>
        <translation>Tangente</translation>
    </message>
    <message>
        <source>curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Snap distance</source>
        <translation>Fangabstand</translation>
    </message>
    <message>
        <source>distances between features</source>
        <translation>Abstände zwischen den Merkmalen</translation>
    </message>
    <message>
        <source>CPU time of a tick</source>
        <translation>Rechenzeit eines Takts</translation>
    </message>
    <message>
        <source>RMS difference from the sum of all forces</source>
        <translation>RMS-Abweichung von der Summe aller Kräfte</translation>
    </message>
    <message>
        <source>Tolerance of the contact point</source>
        <translation>Toleranz des Berührpunkts</translation>
    </message>
    <message>
        <source>diagonals of the model</source>
        <translation>Diagonalen des Modells</translation>
    </message>
    <message>
        <source>Rate of the servo loop</source>
        <translation>Takt der Servoschleife</translation>
    </message>
    <message>
        <source>CPU time of a second of touch</source>
        <translation>Rechenzeit für eine Sekunde Berührung</translation>
    </message>
    <message>
        <source>Stiffness of surfaces</source>
        <translation>Steifigkeit von Flächen</translation>
    </message>
    <message>
        <source>rate of the servo loop that keeps it stable</source>
        <translation>Takt der Servoschleife, der sie stabil hält</translation>
    </message>
    <message>
        <source>Velocity window</source>
        <translation>Zeitfenster der Geschwindigkeit</translation>
    </message>
    <message>
        <source>RMS error of the velocity</source>
        <translation>RMS-Fehler der Geschwindigkeit</translation>
    </message>
    <message>
        <source>CPU time of cutting and of the triangles that change</source>
        <translation>Rechenzeit eines Schnitts mit seinen neuen Dreiecken</translation>
    </message>
    <message>
        <source>largest distance from the surface, in diagonals</source>
        <translation>größter Abstand von der Fläche, in Diagonalen</translation>
    </message>
    <message>
        <source>triangles of the mesh</source>
        <translation>Dreiecke des Netzes</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>eben</translation>
    </message>
    <message>
        <source>Deviation of triangles from the surfaces of a STEP file to aim at</source>
        <translation>Angestrebte Abweichung der Dreiecke von den Flächen einer STEP-Datei</translation>
    </message>
    <message>
        <source>penetration at 2 N into the stiffest wall that the rate allows</source>
        <translation>Eindringtiefe bei 2 N in die steifste Wand, die die Rate erlaubt</translation>
    </message>
    <message>
        <source>penetration at 2 N into the surface</source>
        <translation>Eindringtiefe in die Fläche bei 2 N</translation>
    </message>
    <message>
        <source>delay of the velocity</source>
        <translation>Verzögerung der Geschwindigkeit</translation>
    </message>
    <message>
        <source>features missed by a trembling hand</source>
        <translation>Merkmale, die eine zitternde Hand verfehlt hat</translation>
    </message>
    <message>
        <source>Features that attract at the same time</source>
        <translation>Merkmale, die gleichzeitig anziehen</translation>
    </message>
    <message>
        <source>Sample spacing of a turned profile</source>
        <translation>Abtastabstand eines gedrehten Profils</translation>
    </message>
    <message>
        <source>largest distance of the profile from the exact shape</source>
        <translation>größter Abstand des Profils von der exakten Form</translation>
    </message>
    <message>
        <source>Distance below which boundary vertices are merged</source>
        <translation>Abstand, unter dem Randeckpunkte verschmolzen werden</translation>
    </message>
    <message>
        <source>boundary vertices left unmerged or merged wrongly</source>
        <translation>nicht oder falsch verschmolzene Randeckpunkte</translation>
    </message>
    <message>
        <source>CPU time to merge the boundary vertices</source>
        <translation>CPU-Zeit, um die Randeckpunkte zu verschmelzen</translation>
    </message>
    <message>
        <source>Continuity of fair patches with their surroundings</source>
        <translation>Stetigkeit glatter Füllflächen zu ihrer Umgebung</translation>
    </message>
    <message>
        <source>Density of patches, relative to their surroundings</source>
        <translation>Dichte der Füllflächen, relativ zu ihrer Umgebung</translation>
    </message>
    <message>
        <source>Largest distance from the original when triangles are reduced</source>
        <translation>Größter Abstand vom Original beim Reduzieren der Dreiecke</translation>
    </message>
    <message>
        <source>remaining triangles</source>
        <translation>verbleibende Dreiecke</translation>
    </message>
    <message>
        <source>Vertices or triangles in a block of an undo step</source>
        <translation>Eckpunkte oder Dreiecke in einem Block eines Rückgängig-Schritts</translation>
    </message>
    <message>
        <source>Triangles in a block of the display</source>
        <translation>Dreiecke in einem Block der Anzeige</translation>
    </message>
    <message>
        <source>CPU time to rebuild the blocks that an edit of one triangle affects</source>
        <translation>CPU-Zeit zum Neuaufbau der Blöcke, die die Änderung eines Dreiecks betrifft</translation>
    </message>
    <message>
        <source>Largest deviation of triangles from a curved surface</source>
        <translation>Größte Abweichung der Dreiecke von einer gekrümmten Fläche</translation>
    </message>
    <message>
        <source>RMS distance from its final position</source>
        <translation>RMS-Abstand von der Endlage</translation>
    </message>
    <message>
        <source>Method of reducing triangles</source>
        <translation>Verfahren zum Verringern der Dreiecke</translation>
    </message>
    <message>
        <source>bounded</source>
        <translation>begrenzt</translation>
    </message>
    <message>
        <source>quadric</source>
        <translation>Quadrik</translation>
    </message>
    <message>
        <source>CPU time to remove triangles</source>
        <translation>CPU-Zeit zum Entfernen von Dreiecken</translation>
    </message>
    <message>
        <source>Law of the cutting force</source>
        <translation>Gesetz der Schnittkraft</translation>
    </message>
    <message>
        <source>largest difference from the cited tables</source>
        <translation>größter Unterschied zu den genannten Tabellen</translation>
    </message>
    <message>
        <source>CPU time of one force</source>
        <translation>Rechenzeit einer Kraft</translation>
    </message>
    <message>
        <source>Method of cutting a turned profile</source>
        <translation>Verfahren beim Schneiden eines Drehprofils</translation>
    </message>
    <message>
        <source>Distance of the control points of a turned profile</source>
        <translation>Abstand der Kontrollpunkte eines Drehprofils</translation>
    </message>
    <message>
        <source>Tolerance of the distances that are felt</source>
        <translation>Toleranz der gefühlten Abstände</translation>
    </message>
    <message>
        <source>largest error of a distance</source>
        <translation>größter Fehler eines Abstands</translation>
    </message>
    <message>
        <source>CPU time of a query</source>
        <translation>Rechenzeit einer Abfrage</translation>
    </message>
    <message>
        <source>Step of the simulation of a lathe</source>
        <translation>Schritt der Simulation einer Drehmaschine</translation>
    </message>
    <message>
        <source>CPU time of a second of cutting</source>
        <translation>Rechenzeit für eine Sekunde Zerspanung</translation>
    </message>
    <message>
        <source>Resolution of the proof that a motion is free</source>
        <translation>Auflösung des Beweises, dass eine Bewegung frei ist</translation>
    </message>
    <message>
        <source>CPU time to prove a motion free</source>
        <translation>Rechenzeit, um eine Bewegung als frei zu beweisen</translation>
    </message>
    <message>
        <source>Attempts to make a planned path shorter</source>
        <translation>Versuche, eine geplante Bahn zu kürzen</translation>
    </message>
    <message>
        <source>mean length of paths beyond the shortest one known</source>
        <translation>mittlere Länge der Bahnen über die kürzeste bekannte hinaus</translation>
    </message>
    <message>
        <source>CPU time to plan a path and make it shorter</source>
        <translation>Rechenzeit, um eine Bahn zu planen und zu kürzen</translation>
    </message>
    <message>
        <source>Tolerance of inverse kinematics by iteration</source>
        <translation>Toleranz der iterativen inversen Kinematik</translation>
    </message>
    <message>
        <source>largest distance of the flange from its pose</source>
        <translation>größter Abstand des Flansches von seiner Pose</translation>
    </message>
    <message>
        <source>CPU time of a solution</source>
        <translation>Rechenzeit einer Lösung</translation>
    </message>
    <message>
        <source>collision-free motions near obstacles that are rejected</source>
        <translation>abgelehnte kollisionsfreie Bewegungen nahe an Hindernissen</translation>
    </message>
    <message>
        <source>Step of the checks of motions that are not proven free</source>
        <translation>Schrittweite der Prüfung von Bewegungen, die nicht als frei bewiesen sind</translation>
    </message>
    <message>
        <source>colliding motions that checks at this step alone miss</source>
        <translation>kollidierende Bewegungen, die Prüfungen mit dieser Schrittweite allein übersehen</translation>
    </message>
    <message>
        <source>CPU time to check a motion</source>
        <translation>CPU-Zeit, um eine Bewegung zu prüfen</translation>
    </message>
    <message>
        <source>Voxels along the largest extent of a part</source>
        <translation>Voxel entlang der größten Ausdehnung eines Teils</translation>
    </message>
    <message>
        <source>largest distance of the surface from the part, in extents</source>
        <translation>größter Abstand der Oberfläche vom Teil, in Ausdehnungen</translation>
    </message>
    <message>
        <source>CPU time to make the volume and its surface</source>
        <translation>CPU-Zeit, um das Volumen und seine Oberfläche zu erzeugen</translation>
    </message>
    <message>
        <source>How voxels are sampled</source>
        <translation>Abtastung der Voxel</translation>
    </message>
    <message>
        <source>sign</source>
        <translation>Vorzeichen</translation>
    </message>
    <message>
        <source>density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>largest distance of the surface from the part, in voxels</source>
        <translation>größter Abstand der Oberfläche vom Teil, in Voxeln</translation>
    </message>
    <message>
        <source>CPU time to make the volume</source>
        <translation>CPU-Zeit, um das Volumen zu erzeugen</translation>
    </message>
    <message>
        <source>Voxels that a repair by volume may move the surface by to save triangles</source>
        <translation>Voxel, um die eine volumetrische Reparatur die Oberfläche verschieben darf, um Dreiecke zu sparen</translation>
    </message>
    <message>
        <source>How a volume becomes triangles</source>
        <translation>Umwandlung eines Volumens in Dreiecke</translation>
    </message>
    <message>
        <source>marching</source>
        <translation>Marching Cubes</translation>
    </message>
    <message>
        <source>dual</source>
        <translation>Dual Contouring</translation>
    </message>
    <message>
        <source>RMS distance of edges from the surface, in voxels</source>
        <translation>RMS-Abstand der Kanten von der Oberfläche, in Voxeln</translation>
    </message>
    <message>
        <source>CPU time to make the triangles</source>
        <translation>CPU-Zeit, um die Dreiecke zu erzeugen</translation>
    </message>
    <message>
        <source>What a voxel loses to a drill in a cycle, in lengths of its way</source>
        <translation>Was ein Voxel in einem Takt an einen Bohrer verliert, in Längen von dessen Weg</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>RMS error of the thrust</source>
        <translation>RMS-Fehler der Vorschubkraft</translation>
    </message>
    <message>
        <source>CPU time of a cycle</source>
        <translation>CPU-Zeit eines Takts</translation>
    </message>
    <message>
        <source>Cells of a volume along a piece of its display</source>
        <translation>Zellen eines Volumens entlang eines Stücks seiner Anzeige</translation>
    </message>
    <message>
        <source>CPU time to renew the pieces that a touch of clay changes</source>
        <translation>CPU-Zeit, um die Stücke zu erneuern, die eine Berührung des Tons ändert</translation>
    </message>
</context>
<context>
    <name>FidelityPanel</name>
    <message>
        <source>%1 % of a processor core for the servo loop</source>
        <translation>%1 % eines Prozessorkerns für die Servoschleife</translation>
    </message>
    <message>
        <source>%1 % of a servo tick (%2 µs)</source>
        <translation>%1 % eines Regeltakts (%2 µs)</translation>
    </message>
    <message>
        <source>%1 % of the servo rate for stiffness</source>
        <translation>%1 % der Takte für die Steifigkeit</translation>
    </message>
    <message>
        <source>%1 % of a frame (%2 ms)</source>
        <translation>%1 % eines Bildes (%2 ms)</translation>
    </message>
    <message>
        <source>%1 % of a second for a repair</source>
        <translation>%1 % einer Sekunde für eine Reparatur</translation>
    </message>
    <message>
        <source>%1 % of a second for a fill</source>
        <translation>%1 % einer Sekunde für eine Füllung</translation>
    </message>
    <message>
        <source>Most accurate value that leaves a third of the limit unused. Takes %1.</source>
        <translation>Genauester Wert, der ein Drittel der Grenze frei lässt. Braucht %1.</translation>
    </message>
    <message>
        <source>%1: no value is fast enough, the fastest is used.</source>
        <translation>%1: Kein Wert ist schnell genug, es gilt der schnellste.</translation>
    </message>
</context>
<context>
    <name>Figure</name>
    <message>
        <source>Time of the work</source>
        <translation>Zeit der Arbeit</translation>
    </message>
    <message>
        <source>Hints looked at</source>
        <translation>Angesehene Hinweise</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Diameter of a bore</source>
        <translation>Durchmesser einer Bohrung</translation>
    </message>
    <message>
        <source>Length between two faces</source>
        <translation>Länge zwischen zwei Planflächen</translation>
    </message>
    <message>
        <source>Depth of a bore to a face</source>
        <translation>Tiefe einer Bohrung bis zu einer Planfläche</translation>
    </message>
    <message>
        <source>Radius of an arc</source>
        <translation>Radius eines Bogens</translation>
    </message>
    <message>
        <source>Radius of an arc inside</source>
        <translation>Radius eines Bogens innen</translation>
    </message>
    <message>
        <source>Angle of a taper to the axis</source>
        <translation>Winkel eines Kegels zur Achse</translation>
    </message>
    <message>
        <source>Largest deviation from the target</source>
        <translation>Größte Abweichung vom Ziel</translation>
    </message>
    <message>
        <source>Roughness Ra</source>
        <translation>Rauheit Ra</translation>
    </message>
    <message>
        <source>Roughness Ra inside</source>
        <translation>Rauheit Ra innen</translation>
    </message>
    <message>
        <source>Largest resultant force</source>
        <translation>Größte Zerspankraft</translation>
    </message>
    <message>
        <source>Largest motor power</source>
        <translation>Größte Motorleistung</translation>
    </message>
    <message>
        <source>Time of all passes</source>
        <translation>Zeit aller Schnitte</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Bore</source>
        <translation>Bohrung</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Path of the tool</source>
        <translation>Weg des Werkzeugs</translation>
    </message>
    <message>
        <source>Centre of the nose</source>
        <translation>Mitte der Schneidenecke</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Resultant force</source>
        <translation>Zerspankraft</translation>
    </message>
    <message>
        <source>Motor power</source>
        <translation>Motorleistung</translation>
    </message>
    <message>
        <source>Pitch of a thread</source>
        <translation>Steigung eines Gewindes</translation>
    </message>
    <message>
        <source>Major diameter of a thread</source>
        <translation>Außendurchmesser eines Gewindes</translation>
    </message>
    <message>
        <source>Pitch diameter of a thread</source>
        <translation>Flankendurchmesser eines Gewindes</translation>
    </message>
    <message>
        <source>Minor diameter of a thread</source>
        <translation>Kerndurchmesser eines Gewindes</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Material left over the target</source>
        <translation>Restmaterial über dem Ziel</translation>
    </message>
    <message>
        <source>Cut too deep</source>
        <translation>Zu tief geschnitten</translation>
    </message>
    <message>
        <source>Collisions and feeds too high</source>
        <translation>Kollisionen und zu hohe Vorschübe</translation>
    </message>
    <message>
        <source>Breakthrough</source>
        <translation>Durchbruch</translation>
    </message>
    <message>
        <source>Thrust</source>
        <translation>Vorschubkraft</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>Depth of the tip</source>
        <translation>Tiefe der Spitze</translation>
    </message>
    <message>
        <source>Beside the path</source>
        <translation>Neben der Bahn</translation>
    </message>
    <message>
        <source>Temperature rise (estimate)</source>
        <translation>Temperaturanstieg (Schätzung)</translation>
    </message>
    <message>
        <source>Deviation from the planned path</source>
        <translation>Abweichung von der geplanten Bahn</translation>
    </message>
    <message>
        <source>Time from contact to breakthrough</source>
        <translation>Zeit von der Berührung bis zum Durchbruch</translation>
    </message>
    <message>
        <source>Plunge beyond the inner surface</source>
        <translation>Überstand hinter der inneren Oberfläche</translation>
    </message>
    <message>
        <source>Depth in the forbidden region</source>
        <translation>Tiefe im verbotenen Bereich</translation>
    </message>
    <message>
        <source>Largest thrust</source>
        <translation>Größte Vorschubkraft</translation>
    </message>
    <message>
        <source>Mean thrust in the last millimetre</source>
        <translation>Mittlere Vorschubkraft auf dem letzten Millimeter</translation>
    </message>
    <message>
        <source>Largest torque</source>
        <translation>Größtes Drehmoment</translation>
    </message>
    <message>
        <source>Time of the hole</source>
        <translation>Zeit des Bohrlochs</translation>
    </message>
    <message>
        <source>Drilling</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>Thrust reference (He 2008)</source>
        <translation>Referenz Vorschubkraft (He 2008)</translation>
    </message>
    <message>
        <source>Torque reference (He 2008)</source>
        <translation>Referenz Drehmoment (He 2008)</translation>
    </message>
    <message>
        <source>Diameter at an end of a taper</source>
        <translation>Durchmesser an einem Ende eines Kegels</translation>
    </message>
    <message>
        <source>Length of a taper</source>
        <translation>Länge eines Kegels</translation>
    </message>
    <message>
        <source>Tries</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Z from the finished face</source>
        <translation>Z von der fertigen Planfläche aus</translation>
    </message>
    <message>
        <source>Z from the free end of the bar</source>
        <translation>Z vom freien Ende der Stange aus</translation>
    </message>
</context>
<context>
    <name>FileFilters</name>
    <message>
        <source>All files</source>
        <translation>Alle Dateien</translation>
    </message>
    <message>
        <source>Handwheel documents</source>
        <translation>Handwheel-Dokumente</translation>
    </message>
    <message>
        <source>All formats</source>
        <translation>Alle Formate</translation>
    </message>
    <message>
        <source>All supported files</source>
        <translation>Alle unterstützten Dateien</translation>
    </message>
</context>
<context>
    <name>HandGuidingTool</name>
    <message>
        <source>Lead the robot</source>
        <translation>Roboter führen</translation>
    </message>
    <message>
        <source>Pull place %1 of %2</source>
        <translation>Punkt %1 von %2 ziehen</translation>
    </message>
</context>
<context>
    <name>HapticSession</name>
    <message>
        <source>Simulated hand</source>
        <translation>Simulierte Hand</translation>
    </message>
    <message>
        <source>%1 could not be opened</source>
        <translation>%1 konnte nicht geöffnet werden</translation>
    </message>
    <message>
        <source>%1 has failed</source>
        <translation>%1 ist ausgefallen</translation>
    </message>
    <message>
        <source>Mouse as device</source>
        <translation>Maus als Gerät</translation>
    </message>
    <message>
        <source>%1 is not connected</source>
        <translation>%1 ist nicht angeschlossen</translation>
    </message>
    <message>
        <source>It does not respond correctly.</source>
        <translation>Es antwortet nicht richtig.</translation>
    </message>
    <message>
        <source>A device plugin could not be loaded</source>
        <translation>Ein Gerätemodul konnte nicht geladen werden</translation>
    </message>
    <message>
        <source>It does not answer any more.</source>
        <translation>Es antwortet nicht mehr.</translation>
    </message>
    <message>
        <source>Plug it in and switch it on. If it is not opened automatically then, press “Open again”.</source>
        <translation>Schließen Sie es an und schalten Sie es ein. Wird es dann nicht von selbst geöffnet, drücken Sie „Erneut öffnen“.</translation>
    </message>
    <message>
        <source>Unplug it and plug it in again. If it is not opened automatically then, press “Open again”.</source>
        <translation>Ziehen Sie es ab und schließen Sie es wieder an. Wird es dann nicht von selbst geöffnet, drücken Sie „Erneut öffnen“.</translation>
    </message>
    <message>
        <source>Open again</source>
        <translation>Erneut öffnen</translation>
    </message>
    <message>
        <source>Simulated hand with torque</source>
        <translation>Simulierte Hand mit Drehmoment</translation>
    </message>
</context>
<context>
    <name>HelpPages</name>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>About Handwheel</source>
        <translation>Über Handwheel</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public Licence, version 3 or later.&lt;br&gt;Built with Qt, VTK, CGAL, Open CASCADE, Eigen, libzip and expat.</source>
        <translation>Freie Software unter der GNU General Public License, Version 3 oder später.&lt;br&gt;Gebaut mit Qt, VTK, CGAL, Open CASCADE, Eigen, libzip und expat.</translation>
    </message>
    <message>
        <source>Currently available</source>
        <translation>Derzeit verfügbar</translation>
    </message>
    <message>
        <source>Repairs scanned meshes, shapes and drills volumes, turns workpieces, plans robot cells, and sets and marks exercises.</source>
        <translation>Repariert gescannte Netze, formt und bohrt Volumen, dreht Werkstücke, plant Roboterzellen, stellt und bewertet Übungen.</translation>
    </message>
</context>
<context>
    <name>IkSolutionText</name>
    <message>
        <source>Shoulder in front</source>
        <translation>Schulter vorn</translation>
    </message>
    <message>
        <source>Shoulder behind</source>
        <translation>Schulter hinten</translation>
    </message>
    <message>
        <source>Shoulder left</source>
        <translation>Schulter links</translation>
    </message>
    <message>
        <source>Shoulder right</source>
        <translation>Schulter rechts</translation>
    </message>
    <message>
        <source>elbow up</source>
        <translation>Ellbogen oben</translation>
    </message>
    <message>
        <source>elbow down</source>
        <translation>Ellbogen unten</translation>
    </message>
    <message>
        <source>wrist flipped</source>
        <translation>Handgelenk umgeklappt</translation>
    </message>
    <message>
        <source>wrist not flipped</source>
        <translation>Handgelenk nicht umgeklappt</translation>
    </message>
    <message>
        <source>%1 beyond its limits</source>
        <translation>%1 außerhalb seiner Grenzen</translation>
    </message>
    <message>
        <source>collides: %1 with %2</source>
        <translation>stößt an: %1 mit %2</translation>
    </message>
    <message>
        <source>Way %1</source>
        <translation>Stellung %1</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>turned off by %1°</source>
        <translation>um %1° verdreht</translation>
    </message>
</context>
<context>
    <name>IkSolutionsTool</name>
    <message>
        <source>Change the configuration of the arm</source>
        <translation>Stellung des Arms wechseln</translation>
    </message>
    <message>
        <source>Move the tool</source>
        <translation>Werkzeug bewegen</translation>
    </message>
</context>
<context>
    <name>JointDragTool</name>
    <message>
        <source>Pull the arm</source>
        <translation>Arm ziehen</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 bewegen</translation>
    </message>
</context>
<context>
    <name>KindMenus</name>
    <message>
        <source>No document is open.</source>
        <translation>Es ist kein Dokument geöffnet.</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Dokument</translation>
    </message>
</context>
<context>
    <name>LathePart</name>
    <message>
        <source>Cutting edge</source>
        <translation>Schneide</translation>
    </message>
    <message>
        <source>Tool holder</source>
        <translation>Werkzeughalter</translation>
    </message>
    <message>
        <source>Tool post</source>
        <translation>Stahlhalter</translation>
    </message>
    <message>
        <source>Compound slide</source>
        <translation>Oberschlitten</translation>
    </message>
    <message>
        <source>Quill</source>
        <translation>Pinole</translation>
    </message>
    <message>
        <source>Tailstock</source>
        <translation>Reitstock</translation>
    </message>
    <message>
        <source>Jaws</source>
        <translation>Backen</translation>
    </message>
    <message>
        <source>Chuck</source>
        <translation>Futter</translation>
    </message>
    <message>
        <source>Workpiece</source>
        <translation>Werkstück</translation>
    </message>
    <message>
        <source>These parts must not touch.</source>
        <translation>Diese Teile dürfen sich nicht berühren.</translation>
    </message>
    <message>
        <source>The rapid traverse ran into the workpiece.</source>
        <translation>Der Eilgang fuhr in das Werkstück.</translation>
    </message>
    <message>
        <source>The spindle was at rest.</source>
        <translation>Die Spindel stand still.</translation>
    </message>
    <message>
        <source>The spindle turned backwards.</source>
        <translation>Die Spindel lief rückwärts.</translation>
    </message>
    <message>
        <source>The cut was deeper than the cutting edge is long.</source>
        <translation>Der Schnitt war tiefer, als die Schneide lang ist.</translation>
    </message>
    <message>
        <source>There is no such tool.</source>
        <translation>Dieses Werkzeug gibt es nicht.</translation>
    </message>
    <message>
        <source>The exercise does not provide this tool.</source>
        <translation>Die Übung stellt dieses Werkzeug nicht bereit.</translation>
    </message>
    <message>
        <source>The spindle turns. Stop it before you change tools.</source>
        <translation>Die Spindel dreht sich. Halten Sie sie an, bevor Sie das Werkzeug wechseln.</translation>
    </message>
    <message>
        <source>There is no room for it here. Move the slides away from the work first.</source>
        <translation>Hier ist kein Platz dafür. Fahren Sie die Schlitten zuerst vom Werkstück weg.</translation>
    </message>
    <message>
        <source>The cut needed more power than the motor has.</source>
        <translation>Der Schnitt brauchte mehr Leistung, als der Motor hat.</translation>
    </message>
    <message>
        <source>A file, paper or a disk follows the hand, not a program.</source>
        <translation>Feile, Papier und Scheibe folgen der Hand, keinem Programm.</translation>
    </message>
    <message>
        <source>Programs cut threads with a point of 60°, which this thread does not have.</source>
        <translation>Programme schneiden Gewinde mit einer Spitze von 60°, die dieses Gewinde nicht hat.</translation>
    </message>
    <message>
        <source>The tool cut on a side that it is not made for.</source>
        <translation>Das Werkzeug schnitt auf einer Seite, für die es nicht gemacht ist.</translation>
    </message>
</context>
<context>
    <name>LatheReadout</name>
    <message>
        <source>Kosilova</source>
        <translation>Kosilova</translation>
    </message>
    <message>
        <source>Kienzle</source>
        <translation>Kienzle</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>Netzwerk</translation>
    </message>
</context>
<context>
    <name>LatheTool</name>
    <message>
        <source>Turning tool, right</source>
        <translation>Drehmeißel, rechts</translation>
    </message>
    <message>
        <source>Turning tool, left</source>
        <translation>Drehmeißel, links</translation>
    </message>
    <message>
        <source>Facing tool</source>
        <translation>Plandrehmeißel</translation>
    </message>
    <message>
        <source>Parting tool</source>
        <translation>Abstechmeißel</translation>
    </message>
    <message>
        <source>Grooving tool</source>
        <translation>Einstechmeißel</translation>
    </message>
    <message>
        <source>Form tool</source>
        <translation>Formdrehmeißel</translation>
    </message>
    <message>
        <source>Threading tool</source>
        <translation>Gewindedrehmeißel</translation>
    </message>
    <message>
        <source>Boring bar</source>
        <translation>Innendrehmeißel</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Bohrer</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Feile</translation>
    </message>
    <message>
        <source>Abrasive paper</source>
        <translation>Schleifpapier</translation>
    </message>
    <message>
        <source>Grinding disk</source>
        <translation>Schleifscheibe</translation>
    </message>
</context>
<context>
    <name>MemoryQuestion</name>
    <message>
        <source>Memory for the voxels</source>
        <translation>Arbeitsspeicher für die Voxel</translation>
    </message>
    <message>
        <source>The voxels need %1. Make them all the same?</source>
        <translation>Die Voxel brauchen %1. Trotzdem erzeugen?</translation>
    </message>
    <message>
        <source>That is more than a quarter, and other programs may become slow. Larger voxels need less.</source>
        <translation>Das ist mehr als ein Viertel, und andere Programme können langsam werden. Größere Voxel brauchen weniger.</translation>
    </message>
    <message>
        <source>&amp;Make them</source>
        <translation>&amp;Erzeugen</translation>
    </message>
    <message>
        <source>about %1 MB of %2 MB available</source>
        <translation>etwa %1 MB von %2 MB verfügbaren</translation>
    </message>
</context>
<context>
    <name>MeshUi</name>
    <message>
        <source>%1: nothing was changed</source>
        <translation>%1: nichts wurde geändert</translation>
    </message>
    <message>
        <source>Is %1 in millimetres?</source>
        <translation>Ist %1 in Millimetern?</translation>
    </message>
    <message>
        <source>Lengths, such as a wall thickness, depend on it. Change the unit before you repair.</source>
        <translation>Längen wie eine Wandstärke hängen davon ab. Ändern Sie die Einheit vor der Reparatur.</translation>
    </message>
    <message>
        <source>Change unit…</source>
        <translation>Einheit ändern …</translation>
    </message>
    <message>
        <source>%1: some sheets stay open</source>
        <translation>%1: Einige Flächen bleiben offen</translation>
    </message>
    <message>
        <source>%1: check what was removed</source>
        <translation>%1: prüfen, was entfernt wurde</translation>
    </message>
    <message>
        <source>The mesh cannot be drilled</source>
        <translation>Das Netz kann nicht gebohrt werden</translation>
    </message>
    <message>
        <source>Why: %1.</source>
        <translation>Grund: %1.</translation>
    </message>
    <message>
        <source>A volume of the part can be drilled in any case.</source>
        <translation>Ein Volumen des Teils kann immer gebohrt werden.</translation>
    </message>
    <message>
        <source>Make a volume</source>
        <translation>Volumen erzeugen</translation>
    </message>
</context>
<context>
    <name>Navigation</name>
    <message>
        <source>Handwheel</source>
        <translation>Handwheel</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>FreeCAD</source>
        <translation>FreeCAD</translation>
    </message>
    <message>
        <source>SolidWorks</source>
        <translation>SolidWorks</translation>
    </message>
    <message>
        <source>Laptop without a middle button</source>
        <translation>Laptop ohne mittlere Taste</translation>
    </message>
    <message>
        <source>Ctrl+</source>
        <translation>Strg+</translation>
    </message>
    <message>
        <source>Alt+</source>
        <translation>Alt+</translation>
    </message>
    <message>
        <source>Shift+</source>
        <translation>Umschalt+</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>orbit</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>zoomen</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
</context>
<context>
    <name>Note</name>
    <message>
        <source>The recordings of the device are not in this file.</source>
        <translation>Die Aufzeichnungen des Geräts stehen nicht in dieser Datei.</translation>
    </message>
    <message>
        <source>The coarser levels of the sculpted patch are not in this file.</source>
        <translation>Die gröberen Stufen der modellierten Füllfläche stehen nicht in dieser Datei.</translation>
    </message>
    <message>
        <source>Solids: %1. Surfaces that belong to none: %2.</source>
        <translation>Volumenkörper: %1. Flächen, die zu keinem gehören: %2.</translation>
    </message>
    <message>
        <source>The body &apos;%1&apos; is linked to %2, which is missing; it is shown as it was when it was read.</source>
        <translation>Der Körper „%1“ ist mit %2 verknüpft, das fehlt; er wird gezeigt, wie er beim Einlesen war.</translation>
    </message>
    <message>
        <source>The body &apos;%1&apos; is linked to %2, which has changed; it is shown as it was before.</source>
        <translation>Der Körper „%1“ ist mit %2 verknüpft, das sich geändert hat; er wird gezeigt, wie er vorher war.</translation>
    </message>
    <message>
        <source>1 hidden body (%1) was left out.</source>
        <translation>1 ausgeblendeter Körper (%1) wurde ausgelassen.</translation>
    </message>
    <message>
        <source>%1 hidden bodies (%2) were left out.</source>
        <translation>%1 ausgeblendete Körper (%2) wurden ausgelassen.</translation>
    </message>
    <message>
        <source>The file: %1.</source>
        <translation>Die Datei: %1.</translation>
    </message>
    <message>
        <source>The single precision of the format moved vertices by up to %1 mm; the number of self-intersections may change by that.</source>
        <translation>Die einfache Genauigkeit des Formats hat Eckpunkte um bis zu %1 mm verschoben; die Zahl der Selbstdurchdringungen kann sich dadurch ändern.</translation>
    </message>
    <message>
        <source>The body measures %1 × %2 × %3 mm.</source>
        <translation>Der Körper misst %1 × %2 × %3 mm.</translation>
    </message>
    <message>
        <source>The body &apos;%1&apos; has a shape that this program does not know (&apos;%2&apos;): it is kept, but cannot be shown. A newer version may know it.</source>
        <translation>Der Körper „%1“ hat eine Form, die dieses Programm nicht kennt („%2“): sie bleibt erhalten, kann aber nicht gezeigt werden. Eine neuere Version kennt sie vielleicht.</translation>
    </message>
    <message>
        <source>The file contains the robot and the bodies in their current position; it has no joints.</source>
        <translation>Die Datei enthält den Roboter und die Körper in ihrer jetzigen Stellung; sie hat keine Gelenke.</translation>
    </message>
    <message>
        <source>The robot is added in its current position, as one mesh: it has no joints and no colours of its own.</source>
        <translation>Der Roboter wird in seiner jetzigen Stellung als ein Netz hinzugefügt: ohne Gelenke und ohne eigene Farben.</translation>
    </message>
    <message>
        <source>It has %1 open edges, %2 edges with more than two triangles, %3 edges with inconsistent orientation and %4 non-manifold vertices.</source>
        <translation>Sie hat %1 offene Kanten, %2 Kanten mit mehr als zwei Dreiecken, %3 Kanten mit widersprüchlicher Orientierung und %4 nicht-mannigfaltige Eckpunkte.</translation>
    </message>
    <message>
        <source>A STEP file contains exact surfaces and no mesh: its faces (%1) were triangulated; the triangles are at most about %2 mm from them.</source>
        <translation>Eine STEP-Datei enthält exakte Flächen und kein Netz: Ihre Flächen (%1) wurden in Dreiecke zerlegt, die höchstens etwa %2 mm von ihnen abweichen.</translation>
    </message>
    <message>
        <source>Its lengths (%1) were converted to millimetres.</source>
        <translation>Ihre Längen (%1) wurden in Millimeter umgerechnet.</translation>
    </message>
    <message>
        <source>The marks of holes to keep open are not in this file (%1 marked).</source>
        <translation>Die Markierungen offen zu lassender Löcher stehen nicht in dieser Datei (%1 markiert).</translation>
    </message>
    <message>
        <source>The file contains one valid solid.</source>
        <translation>Die Datei enthält einen gültigen Volumenkörper.</translation>
    </message>
    <message>
        <source>Rounded to the numbers of this format, %1 more pairs of triangles intersect. 3MF, PLY, OBJ and OFF keep all digits.</source>
        <translation>Auf die Zahlen dieses Formats gerundet, durchdringen sich %1 weitere Paare von Dreiecken. 3MF, PLY, OBJ und OFF behalten alle Stellen.</translation>
    </message>
    <message>
        <source>The part measures %1 × %2 × %3 mm, if its numbers are millimetres: the file does not say its unit.</source>
        <translation>Das Teil misst %1 × %2 × %3 mm, wenn seine Zahlen Millimeter sind: Die Datei nennt keine Einheit.</translation>
    </message>
    <message>
        <source>at Z %1 mm</source>
        <translation>bei Z %1 mm</translation>
    </message>
    <message>
        <source>the first face is missing</source>
        <translation>die erste Planfläche fehlt</translation>
    </message>
    <message>
        <source>the second face is missing</source>
        <translation>die zweite Planfläche fehlt</translation>
    </message>
    <message>
        <source>between Z %1 and %2 mm</source>
        <translation>zwischen Z %1 und %2 mm</translation>
    </message>
    <message>
        <source>there is no arc</source>
        <translation>es gibt keinen Bogen</translation>
    </message>
    <message>
        <source>the surface is within %1 mm of the circle</source>
        <translation>die Oberfläche weicht höchstens %1 mm vom Kreis ab</translation>
    </message>
    <message>
        <source>after %1 s</source>
        <translation>nach %1 s</translation>
    </message>
    <message>
        <source>this figure is not known</source>
        <translation>diese Messgröße ist nicht bekannt</translation>
    </message>
    <message>
        <source>there are too many passes to measure it</source>
        <translation>es sind zu viele Schnitte, um es zu messen</translation>
    </message>
    <message>
        <source>nothing was cut</source>
        <translation>nichts wurde bearbeitet</translation>
    </message>
    <message>
        <source>up to %1 µm, at Z %2 mm</source>
        <translation>bis zu %1 µm, bei Z %2 mm</translation>
    </message>
    <message>
        <source>the exercise has no target</source>
        <translation>die Übung hat kein Ziel</translation>
    </message>
    <message>
        <source>%1 mm too much at Z %2 mm, %3 mm too little at Z %4 mm</source>
        <translation>%1 mm zu viel bei Z %2 mm, %3 mm zu wenig bei Z %4 mm</translation>
    </message>
    <message>
        <source>The tool hit the chuck at Z %1 mm, ⌀%2 mm.</source>
        <translation>Das Werkzeug stieß bei Z %1 mm, ⌀%2 mm gegen das Futter.</translation>
    </message>
    <message>
        <source>The file does not say its unit of length: taken as 1 mm in DXF, a pixel in SVG.</source>
        <translation>Die Datei nennt ihre Längeneinheit nicht: angenommen wird 1 mm in DXF, ein Pixel in SVG.</translation>
    </message>
    <message>
        <source>Not read from the drawing: %1.</source>
        <translation>Aus der Zeichnung nicht gelesen: %1.</translation>
    </message>
    <message>
        <source>Faces that are not of revolution were ignored: %1.</source>
        <translation>Nicht rotationssymmetrische Flächen wurden außer Acht gelassen: %1.</translation>
    </message>
    <message>
        <source>%1 is within %2 and %3</source>
        <translation>%1 liegt zwischen %2 und %3</translation>
    </message>
    <message>
        <source>%1 is not above %2</source>
        <translation>%1 liegt nicht über %2</translation>
    </message>
    <message>
        <source>%1 is not below %2</source>
        <translation>%1 liegt nicht unter %2</translation>
    </message>
    <message>
        <source>%1, without a limit</source>
        <translation>%1, ohne Grenze</translation>
    </message>
    <message>
        <source>it could not be measured</source>
        <translation>es ließ sich nicht messen</translation>
    </message>
    <message>
        <source>%1 is %2 below the lower limit, %3</source>
        <translation>%1 liegt %2 unter der unteren Grenze, %3</translation>
    </message>
    <message>
        <source>%1 is %2 above the upper limit, %3</source>
        <translation>%1 liegt %2 über der oberen Grenze, %3</translation>
    </message>
    <message>
        <source>there is no thread along the range</source>
        <translation>im Bereich gibt es kein Gewinde</translation>
    </message>
    <message>
        <source>%1 grooves, each within %2 mm of the pitch</source>
        <translation>%1 Gewinderillen, jede innerhalb von %2 mm der Steigung</translation>
    </message>
    <message>
        <source>The rapid traverse ran into the work at Z %1 mm, ⌀%2 mm.</source>
        <translation>Der Eilgang fuhr bei Z %1 mm, ⌀%2 mm in das Werkstück.</translation>
    </message>
    <message>
        <source>The spindle turned the wrong way at Z %1 mm, ⌀%2 mm.</source>
        <translation>Die Spindel lief bei Z %1 mm, ⌀%2 mm in der falschen Richtung.</translation>
    </message>
    <message>
        <source>The motor could not turn the spindle at Z %1 mm, ⌀%2 mm.</source>
        <translation>Der Motor konnte die Spindel bei Z %1 mm, ⌀%2 mm nicht drehen.</translation>
    </message>
    <message>
        <source>Bar ⌀%1 × %2 mm, held by the chuck over %3 mm</source>
        <translation>Stange ⌀%1 × %2 mm, auf %3 mm im Futter gespannt</translation>
    </message>
    <message>
        <source>Spindle %1 r/min, feed up to %2 mm per revolution</source>
        <translation>Spindel %1 1/min, Vorschub bis %2 mm je Umdrehung</translation>
    </message>
    <message>
        <source>Tool: %1, nose radius %2 mm</source>
        <translation>Werkzeug: %1, Eckenradius %2 mm</translation>
    </message>
    <message>
        <source>The rings of the mesh leave their circles by up to %1 mm.</source>
        <translation>Die Ringe des Netzes weichen bis zu %1 mm von ihren Kreisen ab.</translation>
    </message>
    <message>
        <source>Threads are in the file as their envelope, without grooves: %1.</source>
        <translation>Gewinde stehen in der Datei als ihre Hüllfläche, ohne Rillen: %1.</translation>
    </message>
    <message>
        <source>there is no arc: the surface is up to %1 mm from any circle</source>
        <translation>es gibt keinen Bogen: Die Oberfläche weicht bis zu %1 mm von jedem Kreis ab</translation>
    </message>
    <message>
        <source>there is no such surface in the range</source>
        <translation>im Bereich gibt es keine solche Fläche</translation>
    </message>
    <message>
        <source>File: %1</source>
        <translation>Datei: %1</translation>
    </message>
    <message>
        <source>Handed in: %1</source>
        <translation>Abgegeben: %1</translation>
    </message>
    <message>
        <source>Not marked: %1</source>
        <translation>Nicht bewertet: %1</translation>
    </message>
    <message>
        <source>Time: %1; recorded: %2. Hints looked at: %3.</source>
        <translation>Zeit: %1; aufgezeichnet: %2. Angesehene Hinweise: %3.</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Side by side: %1, %2</source>
        <translation>Nebeneinander: %1, %2</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <source>en</source>
        <translation>de</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 von %2 Punkten</translation>
    </message>
    <message>
        <source>The work is not in the description.</source>
        <translation>Die Arbeit steht nicht in der Beschreibung.</translation>
    </message>
    <message>
        <source>The numbered columns are the points of these criteria:</source>
        <translation>Die nummerierten Spalten sind die Punkte für diese Kriterien:</translation>
    </message>
    <message>
        <source>Contact.</source>
        <translation>Berührung.</translation>
    </message>
    <message>
        <source>The drill left the planned path by more than %1 mm.</source>
        <translation>Der Bohrer ist um mehr als %1 mm von der geplanten Bahn abgekommen.</translation>
    </message>
    <message>
        <source>Breakthrough: the drill is through the inner surface.</source>
        <translation>Durchbruch: Der Bohrer ist durch die innere Oberfläche.</translation>
    </message>
    <message>
        <source>The drill entered the forbidden region.</source>
        <translation>Der Bohrer ist in den verbotenen Bereich eingedrungen.</translation>
    </message>
    <message>
        <source>The measuring was cancelled.</source>
        <translation>Das Messen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The volume was changed by something else than the drill.</source>
        <translation>Das Volumen wurde durch etwas anderes als den Bohrer geändert.</translation>
    </message>
    <message>
        <source>Another drill, speed or material was used.</source>
        <translation>Bohrer, Drehzahl oder Material waren andere.</translation>
    </message>
    <message>
        <source>Nothing was drilled.</source>
        <translation>Es wurde nichts gebohrt.</translation>
    </message>
    <message>
        <source>The drill did not come through.</source>
        <translation>Der Bohrer ist nicht durchgekommen.</translation>
    </message>
    <message>
        <source>It was entered %1 s after contact.</source>
        <translation>Er wurde %1 s nach der Berührung erreicht.</translation>
    </message>
    <message>
        <source>Twist drill ⌀%1 mm, %2 r/min</source>
        <translation>Spiralbohrer ⌀%1 mm, %2 1/min</translation>
    </message>
    <message>
        <source>Burr ⌀%1 mm, %2 r/min</source>
        <translation>Frässtift ⌀%1 mm, %2 1/min</translation>
    </message>
    <message>
        <source>Ball head ⌀%1 mm, %2 r/min</source>
        <translation>Kugelkopf ⌀%1 mm, %2 1/min</translation>
    </message>
    <message>
        <source>Material: %1</source>
        <translation>Material: %1</translation>
    </message>
    <message>
        <source>Planned path within %1 mm: the green line</source>
        <translation>Geplante Bahn auf %1 mm genau: die grüne Linie</translation>
    </message>
    <message>
        <source>The head must not enter the forbidden region</source>
        <translation>Der Kopf darf nicht in den verbotenen Bereich eindringen</translation>
    </message>
    <message>
        <source>The finished face, zero of the drawing and of programs, is %1 mm behind the free end of the bar, at Z %2 mm; %3 mm of the bar are left behind the part at the chuck&apos;s end.</source>
        <translation>Die fertige Planfläche, Nullpunkt der Zeichnung und der Programme, liegt %1 mm hinter dem freien Ende der Stange, bei Z %2 mm; %3 mm der Stange bleiben hinter dem Teil am Ende im Futter.</translation>
    </message>
    <message>
        <source>The target, ⌀%1 × %2 mm, does not fit into the bar of ⌀%3 × %4 mm. Set the bar to a larger size, then what is left for facing.</source>
        <translation>Das Ziel, ⌀%1 × %2 mm, passt nicht in die Stange von ⌀%3 × %4 mm. Stellen Sie für die Stange ein größeres Maß ein, danach das Aufmaß zum Plandrehen.</translation>
    </message>
    <message>
        <source>A description cannot contain a model solution that was made by hand; it was left out.</source>
        <translation>Eine Beschreibung kann keine Musterlösung enthalten, die von Hand gemacht wurde; sie wurde weggelassen.</translation>
    </message>
    <message>
        <source>Vertices moved apart in the last digits that the file can hold, so that it does not weld them: %1.</source>
        <translation>In den letzten Stellen, die die Datei darstellen kann, auseinandergerückte Eckpunkte, damit diese sie nicht verschweißt: %1.</translation>
    </message>
    <message>
        <source>There is no facing allowance: a part is drilled as it is.</source>
        <translation>Ein Aufmaß zum Plandrehen gibt es nicht: Ein Teil wird gebohrt, wie es ist.</translation>
    </message>
    <message>
        <source>The file does not give the spacing of its samples: 1 mm is assumed.</source>
        <translation>Die Datei gibt den Abstand ihrer Abtastwerte nicht an: 1 mm wird angenommen.</translation>
    </message>
    <message>
        <source>Samples that are not numbers were replaced by the smallest value (%1).</source>
        <translation>Abtastwerte, die keine Zahlen sind, wurden durch den kleinsten Wert (%1) ersetzt.</translation>
    </message>
    <message>
        <source>The file contains several values or images (%1); only the first was read.</source>
        <translation>Die Datei enthält mehrere Werte oder Bilder (%1); nur das erste wurde gelesen.</translation>
    </message>
    <message>
        <source>The slices are tilted by %1° against their stacking direction; this was corrected.</source>
        <translation>Die Schichten sind um %1° gegen ihre Stapelrichtung geneigt; das wurde korrigiert.</translation>
    </message>
    <message>
        <source>Slices of other series were ignored (%1).</source>
        <translation>Schichten anderer Serien wurden ignoriert (%1).</translation>
    </message>
    <message>
        <source>Slices at the position of another slice were ignored (%1).</source>
        <translation>Schichten an der Position einer anderen Schicht wurden ignoriert (%1).</translation>
    </message>
    <message>
        <source>Files that are damaged, or are not greyscale images, were ignored (%1).</source>
        <translation>Dateien, die beschädigt oder keine Graustufenbilder sind, wurden ignoriert (%1).</translation>
    </message>
    <message>
        <source>Values from %1 upwards are taken as material (Otsu&apos;s threshold). Choose any other range in the panel Segmentation or with &apos;handwheel segment&apos;.</source>
        <translation>Werte ab %1 gelten als Material (Otsu-Schwellenwert). Wählen Sie im Feld „Segmentierung“ oder mit „handwheel segment“ einen beliebigen anderen Bereich.</translation>
    </message>
    <message>
        <source>The file contains densities: densities above 0.5 are taken as material.</source>
        <translation>Die Datei enthält Dichten: Dichten über 0,5 gelten als Material.</translation>
    </message>
    <message>
        <source>Other grids of the file were ignored (%1).</source>
        <translation>Andere Gitter der Datei wurden ignoriert (%1).</translation>
    </message>
    <message>
        <source>The drawing is the target of a new bar of ⌀%1 × %2 mm, with %3 mm left for facing at the free end. Enter another size in the panel Stock; for an exercise use Import target… in its panel.</source>
        <translation>Die Zeichnung ist das Ziel einer neuen Stange von ⌀%1 × %2 mm, mit %3 mm Aufmaß zum Plandrehen am freien Ende. Geben Sie im Feld „Rohteil“ ein anderes Maß ein; für eine Übung verwenden Sie „Ziel importieren…“ in ihrem Feld.</translation>
    </message>
    <message>
        <source>The feed was too high at Z %1 mm, ⌀%2 mm: %3 mm per revolution, where at most %4 is allowed.</source>
        <translation>Der Vorschub war bei Z %1 mm, ⌀%2 mm zu hoch: %3 mm je Umdrehung, wo höchstens %4 erlaubt sind.</translation>
    </message>
    <message>
        <source>Parts of the lathe collided at Z %1 mm, ⌀%2 mm.</source>
        <translation>Teile der Drehmaschine kollidierten bei Z %1 mm, ⌀%2 mm.</translation>
    </message>
    <message>
        <source>The tool was fed into the work at rest at Z %1 mm, ⌀%2 mm.</source>
        <translation>Das Werkzeug wurde bei Z %1 mm, ⌀%2 mm in das stehende Werkstück gefahren.</translation>
    </message>
    <message>
        <source>The cut was deeper than the cutting edge is long at Z %1 mm, ⌀%2 mm.</source>
        <translation>Der Schnitt war bei Z %1 mm, ⌀%2 mm tiefer, als die Schneide lang ist.</translation>
    </message>
    <message>
        <source>The cut was too heavy: a resultant force of %1 N, where the lathe takes %2 N.</source>
        <translation>Der Schnitt war zu schwer: eine Zerspankraft von %1 N, wo die Drehmaschine %2 N verträgt.</translation>
    </message>
    <message>
        <source>The cut was too heavy: a motor power of %1 kW, where the lathe has %2 kW.</source>
        <translation>Der Schnitt war zu schwer: eine Motorleistung von %1 kW, wo die Drehmaschine %2 kW hat.</translation>
    </message>
    <message>
        <source>there is no such surface along the whole range</source>
        <translation>eine solche Fläche gibt es nicht über den ganzen Bereich</translation>
    </message>
    <message>
        <source>the arc curves in the opposite direction</source>
        <translation>der Bogen ist in die entgegengesetzte Richtung gekrümmt</translation>
    </message>
    <message>
        <source>the marking scheme does not specify where to measure</source>
        <translation>das Bewertungsschema gibt nicht an, wo zu messen ist</translation>
    </message>
    <message>
        <source>the part does not match its recorded passes</source>
        <translation>das Teil stimmt nicht mit seinen aufgezeichneten Schnitten überein</translation>
    </message>
    <message>
        <source>the surface was not cut along the whole range</source>
        <translation>die Fläche wurde nicht über den ganzen Bereich bearbeitet</translation>
    </message>
    <message>
        <source>the tool that cut it has no nose radius, or the feed was larger than that</source>
        <translation>das Werkzeug, das sie erzeugt hat, hat keinen Eckenradius, oder der Vorschub war größer als dieser</translation>
    </message>
    <message>
        <source>feed too high %1 times, up to %2 mm per revolution where at most %3 is allowed; other collisions: %4</source>
        <translation>%1-mal zu hoher Vorschub, bis zu %2 mm je Umdrehung, wo höchstens %3 erlaubt sind; andere Kollisionen: %4</translation>
    </message>
    <message>
        <source>the marking scheme has no limit for it</source>
        <translation>das Bewertungsschema hat keine Grenze dafür</translation>
    </message>
    <message>
        <source>no points, because “%1” was not met</source>
        <translation>keine Punkte, weil „%1“ nicht erfüllt wurde</translation>
    </message>
    <message>
        <source>Walls thinner than a voxel (%1 mm) were lost: %2 % of the surface is farther than a voxel from the surface of the volume. Choose smaller voxels.</source>
        <translation>Wände dünner als ein Voxel (%1 mm) gingen verloren: %2 % der Oberfläche sind weiter als ein Voxel von der Oberfläche des Volumens entfernt. Wählen Sie kleinere Voxel.</translation>
    </message>
    <message>
        <source>The part in section.</source>
        <translation>Das Teil im Schnitt.</translation>
    </message>
    <message>
        <source>Rounded to the numbers of this format, %1 more triangles have no area. 3MF, PLY, OBJ and OFF keep all digits; or move the part to the origin.</source>
        <translation>Auf die Zahlen dieses Formats gerundet haben %1 weitere Dreiecke keine Fläche. 3MF, PLY, OBJ und OFF behalten alle Stellen; oder verschieben Sie das Teil zum Ursprung.</translation>
    </message>
    <message>
        <source>The hole in section along the planned path. Grey: material that is left. Light blue: drilled. Red: drilled beside the planned hole or in the forbidden region, which is pink. Green: the planned path, with its tolerance. Black: the path of the tip.</source>
        <translation>Das Loch im Schnitt entlang der geplanten Bahn. Grau: Material, das geblieben ist. Hellblau: gebohrt. Rot: neben dem geplanten Loch oder im verbotenen Bereich gebohrt, der rosa ist. Grün: die geplante Bahn mit ihrer Toleranz. Schwarz: die Bahn der Spitze.</translation>
    </message>
    <message>
        <source>after %1 s; too heavy a cut: the lathe takes %2 N</source>
        <translation>nach %1 s; ein zu schwerer Schnitt: die Drehmaschine verträgt %2 N</translation>
    </message>
    <message>
        <source>after %1 s; too heavy a cut: the lathe has %2 kW</source>
        <translation>nach %1 s; ein zu schwerer Schnitt: die Drehmaschine hat %2 kW</translation>
    </message>
    <message>
        <source>%1 of 1 point</source>
        <translation>%1 von 1 Punkt</translation>
    </message>
    <message>
        <source>Resultant force up to %1 N</source>
        <translation>Zerspankraft bis %1 N</translation>
    </message>
    <message>
        <source>Motor power up to %1 kW</source>
        <translation>Motorleistung bis %1 kW</translation>
    </message>
    <message>
        <source>The part in section, with the outline of the target. Blue: material left over the target. Red: cut too deep. The bar behind the part is grey.</source>
        <translation>Das Teil im Schnitt, mit dem Umriss des Ziels. Blau: Material, das über dem Ziel stehen blieb. Rot: zu tief geschnitten. Die Stange hinter dem Teil ist grau.</translation>
    </message>
    <message>
        <source>By hand: programs are not allowed</source>
        <translation>Von Hand: Programme sind nicht erlaubt</translation>
    </message>
    <message>
        <source>The end of ⌀%1 mm is the free one, whose face is finished; the end of ⌀%2 mm is towards the chuck.</source>
        <translation>Das Ende mit ⌀%1 mm ist das freie, dessen Stirnfläche bearbeitet wird; das Ende mit ⌀%2 mm liegt zum Futter hin.</translation>
    </message>
    <message>
        <source>The part is parted off: only the piece at its free end counts.</source>
        <translation>Das Teil ist abgestochen: nur das Stück an seinem freien Ende zählt.</translation>
    </message>
    <message>
        <source>The class and its marks are not in the description.</source>
        <translation>Die Klasse und ihre Noten sind nicht in der Beschreibung.</translation>
    </message>
    <message>
        <source>Pictures and curves are not kept: mark the file again to have them here.</source>
        <translation>Bilder und Kurven werden nicht aufbewahrt: die Datei noch einmal bewerten, um sie hier zu haben.</translation>
    </message>
    <message>
        <source>Try %1 entered the forbidden region by %2 mm, and was taken back.</source>
        <translation>Versuch %1 ist %2 mm in den verbotenen Bereich eingedrungen und wurde zurückgenommen.</translation>
    </message>
    <message>
        <source>Tries that entered it and were taken back: %1 of %2, by %3 mm at most.</source>
        <translation>Versuche, die eingedrungen sind und zurückgenommen wurden: %1 von %2, um höchstens %3 mm.</translation>
    </message>
    <message>
        <source>Tool: %1</source>
        <translation>Werkzeug: %1</translation>
    </message>
    <message>
        <source>The planned path and the forbidden region stay where they are. Adapt them to this volume; a drilled hole can be taken as the path.</source>
        <translation>Die geplante Bahn und der verbotene Bereich bleiben, wo sie sind. Passen Sie sie an dieses Volumen an; ein gebohrtes Loch kann als Bahn übernommen werden.</translation>
    </message>
    <message>
        <source>Commands that cut, such as Thread, are allowed</source>
        <translation>Befehle, die spanen, wie Gewinde, sind erlaubt</translation>
    </message>
    <message>
        <source>the pitch of %1 mm is not that of the thread</source>
        <translation>die Steigung von %1 mm ist nicht die des Gewindes</translation>
    </message>
    <message>
        <source>These marks do not fit the target, which itself would not meet them: %1. Change or delete them.</source>
        <translation>Diese Kriterien passen nicht zum Ziel, das sie selbst nicht erfüllen würde: %1. Ändern oder löschen Sie sie.</translation>
    </message>
    <message>
        <source>a twist drill leaves H11 to H12, here +%1 mm: bore or ream a finer hole</source>
        <translation>ein Spiralbohrer hinterlässt H11 bis H12, hier +%1 mm: Eine feinere Bohrung ist auszudrehen oder zu reiben</translation>
    </message>
    <message>
        <source>The layers are not in this file: they are part of its volume.</source>
        <translation>Die Ebenen sind nicht in dieser Datei: Sie sind Teil ihres Volumens.</translation>
    </message>
    <message>
        <source>The mask is not in this file.</source>
        <translation>Die Maske ist nicht in dieser Datei.</translation>
    </message>
    <message>
        <source>The records of the holes are not in this file.</source>
        <translation>Die Aufzeichnungen der Bohrungen sind nicht in dieser Datei.</translation>
    </message>
    <message>
        <source>The image and its segment are not in this file.</source>
        <translation>Das Bild und sein Segment sind nicht in dieser Datei.</translation>
    </message>
    <message>
        <source>The link %1 is %2 m large. Descriptions are in metres: if the mesh is in mm, give it scale=&quot;0.001 0.001 0.001&quot;.</source>
        <translation>Das Glied %1 ist %2 m groß. Beschreibungen sind in Metern: Ist das Netz in mm, so geben Sie ihm scale=&quot;0.001 0.001 0.001&quot;.</translation>
    </message>
    <message>
        <source>The joint %1 is %2 m from the link before it. Descriptions are in metres: check its origin.</source>
        <translation>Das Gelenk %1 ist %2 m vom Glied davor entfernt. Beschreibungen sind in Metern: Prüfen Sie seinen Ursprung.</translation>
    </message>
    <message>
        <source>Links that touch each other at rest are not checked against each other: %1. Forbid those that must not touch in the list of pairs.</source>
        <translation>Glieder, die einander in Ruhe berühren, werden nicht gegeneinander geprüft: %1. Verbieten Sie in der Liste der Paare, was sich nicht berühren darf.</translation>
    </message>
    <message>
        <source>The spacing of the slices varies from %1 to %2 mm; slices every %3 mm were interpolated.</source>
        <translation>Der Abstand der Schichten schwankt zwischen %1 und %2 mm; es wurden Schichten im Abstand von %3 mm interpoliert.</translation>
    </message>
    <message>
        <source>The positions of the slices are not stated: a spacing of %1 mm is assumed. The order of the slices, and so left and right, may be reversed.</source>
        <translation>Die Positionen der Schichten sind nicht angegeben: Ein Abstand von %1 mm wird angenommen. Die Reihenfolge der Schichten, und damit links und rechts, kann umgekehrt sein.</translation>
    </message>
    <message>
        <source>The image is a map of labels (%1): all of them are taken as material. Choose others in the panel Segmentation or with &apos;handwheel segment&apos;.</source>
        <translation>Das Bild ist eine Karte von Labels (%1): Alle gelten als Material. Andere lassen sich im Feld Segmentierung oder mit &apos;handwheel segment&apos; wählen.</translation>
    </message>
    <message>
        <source>Slices are missing (%1); they were interpolated from their neighbours, which are up to %2 mm apart. What begins or ends between these is not known.</source>
        <translation>Schichten fehlen (%1); sie wurden aus ihren Nachbarn interpoliert, die bis zu %2 mm auseinanderliegen. Was dazwischen beginnt oder endet, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Segments overlap in %1 samples, which were given to the last of these segments in the file.</source>
        <translation>Segmente überlappen in %1 Abtastwerten; diese gehören nun dem letzten dieser Segmente in der Datei.</translation>
    </message>
    <message>
        <source>The file states two different positions or orientations of its samples (sform and qform); the sform was used. Check left and right.</source>
        <translation>Die Datei nennt zwei verschiedene Positionen oder Ausrichtungen ihrer Abtastwerte (sform und qform); verwendet wurde die sform. Links und rechts prüfen.</translation>
    </message>
    <message>
        <source>The body was copied and not linked, as the path of an image often contains the patient&apos;s name.</source>
        <translation>Der Körper wurde kopiert und nicht verknüpft, da der Pfad eines Bildes oft den Namen des Patienten enthält.</translation>
    </message>
    <message>
        <source>Material was lost: walls are thinner than two voxels (%1 mm) beside %2 % of the surface (%3 mm²), the thinnest %4 mm at (%5). Beside %6 mm² of it half of their thickness or more is gone. Voxels of half the thickness keep a wall.</source>
        <translation>Material ging verloren: Wände sind dünner als zwei Voxel (%1 mm), an %2 % der Fläche (%3 mm²), die dünnste %4 mm bei (%5). An %6 mm² davon fehlt die Hälfte ihrer Dicke oder mehr. Voxel von halber Dicke erhalten eine Wand.</translation>
    </message>
    <message>
        <source>Walls are thinner than two voxels (%1 mm) beside %2 % of the surface (%3 mm²), the thinnest %4 mm at (%5): they are not exact. Voxels of half the thickness keep a wall.</source>
        <translation>Wände sind dünner als zwei Voxel (%1 mm), an %2 % der Fläche (%3 mm²), die dünnste %4 mm bei (%5): Sie sind nicht genau. Voxel von halber Dicke erhalten eine Wand.</translation>
    </message>
    <message>
        <source>Gaps were filled: they are narrower than two voxels (%1 mm) beside %2 % of the surface (%3 mm²), the narrowest %4 mm at (%5). Beside %6 mm² of it half of their width or more is filled. Voxels of half the width keep a gap.</source>
        <translation>Spalte wurden gefüllt: Sie sind schmaler als zwei Voxel (%1 mm), an %2 % der Fläche (%3 mm²), der schmalste %4 mm bei (%5). An %6 mm² davon ist die Hälfte ihrer Breite oder mehr gefüllt. Voxel von halber Breite erhalten einen Spalt.</translation>
    </message>
    <message>
        <source>Gaps are narrower than two voxels (%1 mm) beside %2 % of the surface (%3 mm²), the narrowest %4 mm at (%5): they are not exact. Voxels of half the width keep a gap.</source>
        <translation>Spalte sind schmaler als zwei Voxel (%1 mm), an %2 % der Fläche (%3 mm²), der schmalste %4 mm bei (%5): Sie sind nicht genau. Voxel von halber Breite erhalten einen Spalt.</translation>
    </message>
    <message>
        <source>This file has the surface of an earlier segment. To write that of the current segment, press “Make surface” and save again.</source>
        <translation>Diese Datei enthält die Oberfläche eines früheren Segments. Für die des aktuellen Segments „Oberfläche erzeugen“ drücken und erneut speichern.</translation>
    </message>
</context>
<context>
    <name>PathStatus</name>
    <message>
        <source>not verified since a robot was moved, added or removed</source>
        <translation>nicht geprüft, seit ein Roboter bewegt, hinzugefügt oder entfernt wurde</translation>
    </message>
    <message>
        <source>not verified since the path was changed</source>
        <translation>nicht geprüft, seit die Bahn geändert wurde</translation>
    </message>
    <message>
        <source>not verified since other joints were moved</source>
        <translation>nicht geprüft, seit andere Gelenke bewegt wurden</translation>
    </message>
    <message>
        <source>not verified since the bodies were changed</source>
        <translation>nicht geprüft, seit die Körper geändert wurden</translation>
    </message>
    <message>
        <source>not verified since the tool centre point was changed</source>
        <translation>nicht geprüft, seit der Werkzeugmittelpunkt geändert wurde</translation>
    </message>
    <message>
        <source>not verified since the clearance was changed</source>
        <translation>nicht geprüft, seit der Abstand geändert wurde</translation>
    </message>
    <message>
        <source>not verified yet</source>
        <translation>noch nicht geprüft</translation>
    </message>
    <message>
        <source>cannot be verified</source>
        <translation>kann nicht geprüft werden</translation>
    </message>
    <message>
        <source>line cannot be followed, %1</source>
        <translation>Linie nicht abfahrbar, %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>free, %1</source>
        <translation>frei, %1</translation>
    </message>
    <message>
        <source>line cannot be followed (%1)</source>
        <translation>Linie nicht abfahrbar (%1)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1, clearance %2</source>
        <translation>%1, Abstand %2</translation>
    </message>
    <message>
        <source>free of collisions (%1)</source>
        <translation>kollisionsfrei (%1)</translation>
    </message>
    <message>
        <source>Verified at %1.</source>
        <translation>Geprüft am %1.</translation>
    </message>
    <message>
        <source>The straight line to place %1 leaves the reach of the arm or the limits of its joints.</source>
        <translation>Die gerade Linie zu Punkt %1 verlässt die Reichweite des Arms oder die Grenzen seiner Gelenke.</translation>
    </message>
    <message>
        <source>Every motion is proven free of collisions.</source>
        <translation>Jede Bewegung ist bewiesen kollisionsfrei.</translation>
    </message>
    <message>
        <source>Least clearance: %1.</source>
        <translation>Kleinster Abstand: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln collision(s)</source>
        <translation>
            <numerusform>%Ln Kollision</numerusform>
            <numerusform>%Ln Kollisionen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1; %2 has moved since</source>
        <translation>%1; %2 hat sich seitdem bewegt</translation>
    </message>
    <message>
        <source>too few places</source>
        <translation>zu wenige Punkte</translation>
    </message>
    <message>
        <source>A path needs at least two places.</source>
        <translation>Eine Bahn braucht mindestens zwei Punkte.</translation>
    </message>
    <message>
        <source>verifying…</source>
        <translation>wird geprüft…</translation>
    </message>
    <message>
        <source>The path is being verified.</source>
        <translation>Die Bahn wird geprüft.</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>Zuvor: %1</translation>
    </message>
    <message>
        <source>plan again: %1 has moved</source>
        <translation>neu planen: %1 wurde bewegt</translation>
    </message>
    <message>
        <source>On the way to place %1: %2 with %3</source>
        <translation>Auf dem Weg zu Punkt %1: %2 mit %3</translation>
    </message>
    <message>
        <source>It was never verified: select the path, or choose Verify all paths.</source>
        <translation>Sie wurde noch nie geprüft: Wählen Sie die Bahn aus, oder wählen Sie „Alle Bahnen prüfen“.</translation>
    </message>
    <message>
        <source>%1, as stored with the cell</source>
        <translation>%1, wie in der Zelle gespeichert</translation>
    </message>
    <message>
        <source>Every motion is proven to keep a clearance of %1.</source>
        <translation>Für jede Bewegung ist bewiesen, dass sie einen Abstand von %1 einhält.</translation>
    </message>
    <message>
        <source>Plan it again.</source>
        <translation>Planen Sie sie neu.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln blend(s) will be exact stops, as not every way within their zones is proven free.</source>
        <translation>
            <numerusform>%Ln Überschleifen wird ein genauer Halt, weil nicht jeder Weg in seiner Zone als frei bewiesen ist.</numerusform>
            <numerusform>%Ln Überschleifen werden genaue Halte, weil nicht jeder Weg in ihren Zonen als frei bewiesen ist.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>too near %Ln time(s)</source>
        <translation>
            <numerusform>%Ln Mal zu nah</numerusform>
            <numerusform>%Ln Mal zu nah</numerusform>
        </translation>
    </message>
    <message>
        <source>plan again: the tool centre point was changed</source>
        <translation>neu planen: der Werkzeugmittelpunkt wurde geändert</translation>
    </message>
    <message>
        <source>plan again: it misses %1</source>
        <translation>neu planen: sie verfehlt %1</translation>
    </message>
    <message>
        <source>On the way to place %1: %2 only %4 from %3</source>
        <translation>Auf dem Weg zu Stelle %1: %2 nur %4 von %3 entfernt</translation>
    </message>
    <message numerus="yes">
        <source>and %Ln more</source>
        <translation>
            <numerusform>und %Ln weitere</numerusform>
            <numerusform>und %Ln weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>It leads along the curve where %1 was when it was planned: the tool does not meet it any more.</source>
        <translation>Sie führt an der Kurve entlang, wo %1 beim Planen war: das Werkzeug trifft sie nicht mehr.</translation>
    </message>
    <message>
        <source>The tool centre point was another one when its curve was planned: that is not met any more.</source>
        <translation>Der Werkzeugmittelpunkt war ein anderer, als ihre Kurve geplant wurde: diese wird nicht mehr getroffen.</translation>
    </message>
    <message>
        <source>The tool does not come to the target %1 any more: that, or the tool, has moved since.</source>
        <translation>Das Werkzeug kommt nicht mehr zum Ziel %1: dieses oder das Werkzeug wurde seitdem bewegt.</translation>
    </message>
    <message>
        <source>plan again: its robot has moved</source>
        <translation>neu planen: ihr Roboter wurde bewegt</translation>
    </message>
    <message>
        <source>Its robot stood elsewhere when its curve was planned: the tool does not meet that any more.</source>
        <translation>Ihr Roboter stand woanders, als ihre Kurve geplant wurde: Das Werkzeug trifft sie nicht mehr.</translation>
    </message>
    <message>
        <source>not verified since its configurations were changed</source>
        <translation>nicht geprüft, seit ihre Konfigurationen geändert wurden</translation>
    </message>
    <message>
        <source>plan again: %1 was changed</source>
        <translation>neu planen: %1 wurde geändert</translation>
    </message>
    <message>
        <source>%1; not checked: %2</source>
        <translation>%1; nicht geprüft: %2</translation>
    </message>
    <message>
        <source>It leads to %1 as that was stored when the path was planned: it was changed since.</source>
        <translation>Sie führt zu %1, wie es bei der Planung gespeichert war: Es wurde seither geändert.</translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <translation>%1 mit %2</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>line cannot be followed</source>
        <translation>der Geraden kann nicht gefolgt werden</translation>
    </message>
    <message>
        <source>not verified since the allowed pairs, or the shapes left out, were changed</source>
        <translation>nicht geprüft, seit die erlaubten Paare oder die weggelassenen Formen geändert wurden</translation>
    </message>
    <message>
        <source>free, but touching, %1</source>
        <translation>frei, aber mit Berührung, %1</translation>
    </message>
    <message>
        <source>free of collisions, but touching (%1)</source>
        <translation>kollisionsfrei, aber mit Berührung (%1)</translation>
    </message>
    <message>
        <source>Estimated cycle time: %1 s.</source>
        <translation>Geschätzte Taktzeit: %1 s.</translation>
    </message>
    <message>
        <source>not proven: the shape of %1 is missing</source>
        <translation>nicht bewiesen: die Form von %1 fehlt</translation>
    </message>
    <message>
        <source>not proven: CNT</source>
        <translation>nicht bewiesen: CNT</translation>
    </message>
    <message>
        <source>proven only as far as what is carried is known</source>
        <translation>nur bewiesen, soweit bekannt ist, was getragen wird</translation>
    </message>
    <message>
        <source>The controller rounds the corner at place %1 (CNT), and not everything within it is free: set its rounding to 0, or change the places.</source>
        <translation>Die Steuerung verrundet die Ecke an Stelle %1 (CNT), und nicht alles darin ist frei: die Verrundung auf 0 setzen oder die Stellen ändern.</translation>
    </message>
    <message>
        <source>The proof ends at place %1: &quot;%2&quot; may grip or release something. Say at that place that the robot carries the same as before.</source>
        <translation>Der Beweis endet an Stelle %1: „%2“ kann etwas greifen oder loslassen. An dieser Stelle angeben, dass der Roboter dasselbe trägt wie zuvor.</translation>
    </message>
    <message>
        <source>The shape of %1 (%2) could not be read, so nothing is proven free: leave it out or replace it in the panel Cell.</source>
        <translation>Die Form von %1 (%2) konnte nicht gelesen werden, daher ist nichts als frei bewiesen: Lassen Sie sie im Feld Zelle weg, oder ersetzen Sie sie.</translation>
    </message>
    <message>
        <source>The shape of %1 (%2) could not be read, and is left out of the proof.</source>
        <translation>Die Form von %1 (%2) konnte nicht gelesen werden und ist im Beweis weggelassen.</translation>
    </message>
    <message>
        <source>The shape of %1 (%2) could not be read, and %3 replaces it.</source>
        <translation>Die Form von %1 (%2) konnte nicht gelesen werden; %3 ersetzt sie.</translation>
    </message>
    <message>
        <source>%1; left out: %2</source>
        <translation>%1; weggelassen: %2</translation>
    </message>
    <message>
        <source>not verified since what is assumed for the times was changed</source>
        <translation>nicht geprüft, seit die Annahmen für die Zeiten geändert wurden</translation>
    </message>
    <message>
        <source>not proven: blend at place %1</source>
        <translation>nicht bewiesen: Überschleifen an Stelle %1</translation>
    </message>
    <message>
        <source>Not everything within the blend of the program at place %1 is free: an export writes %2.</source>
        <translation>Nicht alles innerhalb der Überschleifzone des Programms an Stelle %1 ist frei: Ein Export schreibt %2.</translation>
    </message>
    <message>
        <source>Not everything within the blend of the program at place %1 is free: an export writes an exact stop.</source>
        <translation>Nicht alles innerhalb der Überschleifzone des Programms an Stelle %1 ist frei: Ein Export schreibt einen genauen Halt.</translation>
    </message>
    <message>
        <source>not verified since its targets or frames were moved</source>
        <translation>nicht geprüft, seit ihre Ziele oder Koordinatensysteme bewegt wurden</translation>
    </message>
    <message>
        <source>%1 s of it is waiting.</source>
        <translation>Davon wird %1 s gewartet.</translation>
    </message>
    <message numerus="yes">
        <source>The time of %Ln line(s) that wait for something is not in it.</source>
        <translation>
            <numerusform>Die Zeit von %Ln Zeile, die auf etwas wartet, ist nicht darin.</numerusform>
            <numerusform>Die Zeit von %Ln Zeilen, die auf etwas warten, ist nicht darin.</numerusform>
        </translation>
    </message>
    <message>
        <source>plan again: the frame %1 has moved</source>
        <translation>neu planen: das Koordinatensystem %1 wurde bewegt</translation>
    </message>
    <message>
        <source> (the proof needs %1)</source>
        <translation> (der Nachweis braucht %1)</translation>
    </message>
    <message>
        <source>The frame %1, or the tool, has moved since the program was opened: the path leads to where that was. Plan the path again, or open the program again.</source>
        <translation>Das Koordinatensystem %1 oder das Werkzeug wurde bewegt, seit das Programm geöffnet wurde: Die Bahn führt dorthin, wo es war. Planen Sie die Bahn erneut, oder öffnen Sie das Programm erneut.</translation>
    </message>
</context>
<context>
    <name>PlaceBodyTool</name>
    <message>
        <source>Turn %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 bewegen</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>%1 platzieren</translation>
    </message>
</context>
<context>
    <name>ProgramRemarks</name>
    <message>
        <source>These lines do not say in which way the arm comes to their poses: %1. The path has the nearest way, and a controller may take another one; give joint values or a configuration.</source>
        <translation>Diese Zeilen sagen nicht, auf welche Weise der Arm ihre Posen erreicht: %1. Die Bahn nimmt die nächstliegende, eine Steuerung vielleicht eine andere; Gelenkwerte oder eine Konfiguration angeben.</translation>
    </message>
    <message>
        <source>%1, turned by %2°</source>
        <translation>%1, gedreht um %2°</translation>
    </message>
    <message>
        <source>The tool centre point of the program is at %1, that of the cell at %2. The arm comes to the same places, but lines and blends are those of the cell&apos;s tool: set the tool centre point of the cell to that of the program, and open it again.</source>
        <translation>Der Werkzeugmittelpunkt des Programms liegt bei %1, der der Zelle bei %2. Der Arm erreicht dieselben Stellen, doch Strecken und Überschleifen sind die des Werkzeugs der Zelle: den Werkzeugmittelpunkt der Zelle auf den des Programms setzen und es erneut öffnen.</translation>
    </message>
    <message>
        <source>External axes stand at “%1” in the whole program. The cell does not move them: robot and parts must stand there as they do then. Programs in the same language are written with these axes.</source>
        <translation>Zusatzachsen stehen im ganzen Programm bei „%1“. Die Zelle bewegt sie nicht: Roboter und Teile müssen dort so stehen wie dann. Programme in derselben Sprache werden mit diesen Achsen geschrieben.</translation>
    </message>
    <message>
        <source>The path does not have all that these lines say: %1 (handlers of errors and interrupts, functions, options of motions such as ACC and PTH, speeds that are no numbers). A program that is written from it does not have this either.</source>
        <translation>Die Bahn hat nicht alles, was diese Zeilen sagen: %1 (Behandlung von Fehlern und Unterbrechungen, Funktionen, Zusätze von Bewegungen wie ACC und PTH, Geschwindigkeiten, die keine Zahlen sind). Ein Programm, das aus ihr geschrieben wird, hat dies auch nicht.</translation>
    </message>
</context>
<context>
    <name>Property</name>
    <message>
        <source>Document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>Display unit</source>
        <translation>Anzeigeeinheit</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Size in X</source>
        <translation>Ausdehnung in X</translation>
    </message>
    <message>
        <source>Size in Y</source>
        <translation>Ausdehnung in Y</translation>
    </message>
    <message>
        <source>Size in Z</source>
        <translation>Ausdehnung in Z</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Glied</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>It was cancelled.</source>
        <translation>Es wurde abgebrochen.</translation>
    </message>
    <message>
        <source>It is kept open.</source>
        <translation>Es wird offen gelassen.</translation>
    </message>
    <message>
        <source>It has more edges than allowed.</source>
        <translation>Es hat mehr Kanten als erlaubt.</translation>
    </message>
    <message>
        <source>It would take too long for a mesh of this size.</source>
        <translation>Das würde für ein Netz dieser Größe zu lange dauern.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Fair</source>
        <translation>Stetig</translation>
    </message>
    <message>
        <source>Refined</source>
        <translation>Verfeinert</translation>
    </message>
    <message>
        <source>New triangles</source>
        <translation>Neue Dreiecke</translation>
    </message>
    <message>
        <source>Select by</source>
        <translation>Auswählen mit</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Verbunden</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Size in</source>
        <translation>Größe in</translation>
    </message>
    <message>
        <source>Length on the model</source>
        <translation>Länge am Modell</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Brush radius</source>
        <translation>Pinselradius</translation>
    </message>
    <message>
        <source>Select through the model</source>
        <translation>Durch das Modell hindurch auswählen</translation>
    </message>
    <message>
        <source>Largest angle</source>
        <translation>Größter Winkel</translation>
    </message>
    <message>
        <source>Clipping plane</source>
        <translation>Schnittebene</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>View cube</source>
        <translation>Ansichtswürfel</translation>
    </message>
    <message>
        <source>View direction</source>
        <translation>Blickrichtung</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Lower end at Z</source>
        <translation>Unteres Ende bei Z</translation>
    </message>
    <message>
        <source>Chord tolerance</source>
        <translation>Sehnentoleranz</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Volume (mm³)</source>
        <translation>Volumen (mm³)</translation>
    </message>
    <message>
        <source>Surface (mm²)</source>
        <translation>Oberfläche (mm²)</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Voreinstellung</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Balanced</source>
        <translation>Ausgewogen</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Genau</translation>
    </message>
    <message>
        <source>Ridges</source>
        <translation>Grate</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Angle of three points</source>
        <translation>Winkel aus drei Punkten</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Wandstärke</translation>
    </message>
    <message>
        <source>An edge would have more than two triangles.</source>
        <translation>Eine Kante hätte mehr als zwei Dreiecke.</translation>
    </message>
    <message>
        <source>There is no open edge.</source>
        <translation>Es gibt keine offene Kante.</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Marked triangles</source>
        <translation>Markierte Dreiecke</translation>
    </message>
    <message>
        <source>There is no island in this hole.</source>
        <translation>In diesem Loch gibt es keine Insel.</translation>
    </message>
    <message>
        <source>There is no peninsula in this hole.</source>
        <translation>In diesem Loch gibt es keine Halbinsel.</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Größter Abstand</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Inflate</source>
        <translation>Aufblähen</translation>
    </message>
    <message>
        <source>Flatten</source>
        <translation>Ebnen</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>It would have too many triangles.</source>
        <translation>Er hätte zu viele Dreiecke.</translation>
    </message>
    <message>
        <source>Triangles of the patch</source>
        <translation>Dreiecke der Füllfläche</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Move along X</source>
        <translation>Verschieben in X</translation>
    </message>
    <message>
        <source>Move along Y</source>
        <translation>Verschieben in Y</translation>
    </message>
    <message>
        <source>Move along Z</source>
        <translation>Verschieben in Z</translation>
    </message>
    <message>
        <source>Scale by</source>
        <translation>Skalieren mit</translation>
    </message>
    <message>
        <source>Length of the outline</source>
        <translation>Länge des Umrisses</translation>
    </message>
    <message>
        <source>the outline is open</source>
        <translation>der Umriss ist offen</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Tangents</source>
        <translation>Tangenten</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
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
        <source>Towards you</source>
        <translation>Zu Ihnen hin</translation>
    </message>
    <message>
        <source>X of the device</source>
        <translation>X des Geräts</translation>
    </message>
    <message>
        <source>X, inverted</source>
        <translation>X, umgekehrt</translation>
    </message>
    <message>
        <source>Y of the device</source>
        <translation>Y des Geräts</translation>
    </message>
    <message>
        <source>Y, inverted</source>
        <translation>Y, umgekehrt</translation>
    </message>
    <message>
        <source>Z of the device</source>
        <translation>Z des Geräts</translation>
    </message>
    <message>
        <source>Z, inverted</source>
        <translation>Z, umgekehrt</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Scale (1 fills the view)</source>
        <translation>Maßstab (1 füllt die Ansicht)</translation>
    </message>
    <message>
        <source>Force gain</source>
        <translation>Kraftverstärkung</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation>Totzone</translation>
    </message>
    <message>
        <source>Dead zone in rotation</source>
        <translation>Totzone der Drehung</translation>
    </message>
    <message>
        <source>No button</source>
        <translation>Keine Taste</translation>
    </message>
    <message>
        <source>Clutch: the tip stays while it is held</source>
        <translation>Kupplung: Die Spitze bleibt stehen, solange sie gehalten wird</translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation>Kupplung</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>Stiffness (N/mm)</source>
        <translation>Steifigkeit (N/mm)</translation>
    </message>
    <message>
        <source>Damping (N·s/mm)</source>
        <translation>Dämpfung (N·s/mm)</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Angepasst</translation>
    </message>
    <message>
        <source>Snapping</source>
        <translation>Fangen</translation>
    </message>
    <message>
        <source>Spring</source>
        <translation>Feder</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>Quadratic</source>
        <translation>Parabel</translation>
    </message>
    <message>
        <source>Gaussian</source>
        <translation>Gauß</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Fangen</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>One (proxy)</source>
        <translation>Eines (Proxy)</translation>
    </message>
    <message>
        <source>Sum (force)</source>
        <translation>Summe (Kraft)</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Resistance (N·s/mm)</source>
        <translation>Widerstand (N·s/mm)</translation>
    </message>
    <message>
        <source>the file is missing</source>
        <translation>die Datei fehlt</translation>
    </message>
    <message>
        <source>the file has changed since it was read</source>
        <translation>die Datei hat sich seit dem Einlesen geändert</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>cannot be shown</source>
        <translation>kann nicht gezeigt werden</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Smooth shading</source>
        <translation>Glatt schattiert</translation>
    </message>
    <message>
        <source>Linked file</source>
        <translation>Verknüpfte Datei</translation>
    </message>
    <message>
        <source>State of the file</source>
        <translation>Zustand der Datei</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Size X</source>
        <translation>Größe X</translation>
    </message>
    <message>
        <source>Size Y</source>
        <translation>Größe Y</translation>
    </message>
    <message>
        <source>Size Z</source>
        <translation>Größe Z</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>all joints</source>
        <translation>alle Gelenke</translation>
    </message>
    <message>
        <source>Speed not known</source>
        <translation>Geschwindigkeit unbekannt</translation>
    </message>
    <message>
        <source>Effort not known</source>
        <translation>Kraft unbekannt</translation>
    </message>
    <message>
        <source>Ear clipping</source>
        <translation>Ear-Clipping</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Eben</translation>
    </message>
    <message>
        <source>Rotate about X</source>
        <translation>Drehen um X</translation>
    </message>
    <message>
        <source>Rotate about Y</source>
        <translation>Drehen um Y</translation>
    </message>
    <message>
        <source>Rotate about Z</source>
        <translation>Drehen um Z</translation>
    </message>
    <message>
        <source>Angle between two faces</source>
        <translation>Winkel zweier Flächen</translation>
    </message>
    <message>
        <source>Along a ray</source>
        <translation>Entlang eines Strahls</translation>
    </message>
    <message>
        <source>Largest inscribed sphere</source>
        <translation>Größte einbeschriebene Kugel</translation>
    </message>
    <message>
        <source>Two of the vertices are the same.</source>
        <translation>Zwei der Eckpunkte sind dieselben.</translation>
    </message>
    <message>
        <source>A triangle would be degenerate.</source>
        <translation>Ein Dreieck wäre entartet.</translation>
    </message>
    <message>
        <source>The adjacent triangle has the opposite orientation.</source>
        <translation>Das benachbarte Dreieck ist entgegengesetzt orientiert.</translation>
    </message>
    <message>
        <source>It would touch the surface at a single vertex only.</source>
        <translation>Es würde die Oberfläche nur an einem Eckpunkt berühren.</translation>
    </message>
    <message>
        <source>It would intersect or touch the part.</source>
        <translation>Es würde das Teil durchdringen oder berühren.</translation>
    </message>
    <message>
        <source>A triangle would flip or become degenerate.</source>
        <translation>Ein Dreieck würde umklappen oder entarten.</translation>
    </message>
    <message>
        <source>Wavelength (edges)</source>
        <translation>Wellenlänge (Kanten)</translation>
    </message>
    <message>
        <source>Even spacing</source>
        <translation>Gleichmäßiger Abstand</translation>
    </message>
    <message>
        <source>Dropped onto a vertex</source>
        <translation>Auf einem Eckpunkt abgelegt</translation>
    </message>
    <message>
        <source>Add a bridge</source>
        <translation>Brücke hinzufügen</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Constrained vertices</source>
        <translation>Eingeschränkte Eckpunkte</translation>
    </message>
    <message>
        <source>Moving further would flip a triangle or tear the surface.</source>
        <translation>Eine weitere Bewegung würde ein Dreieck umklappen oder die Oberfläche aufreißen.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Number of triangles</source>
        <translation>Anzahl der Dreiecke</translation>
    </message>
    <message>
        <source>Preserve sharp edges</source>
        <translation>Scharfe Kanten erhalten</translation>
    </message>
    <message>
        <source>It is the outer boundary of an open sheet.</source>
        <translation>Es ist der Außenrand einer offenen Fläche.</translation>
    </message>
    <message>
        <source>No valid patch fits its boundary.</source>
        <translation>Keine gültige Füllfläche passt auf seinen Rand.</translation>
    </message>
    <message>
        <source>Every patch would intersect the part.</source>
        <translation>Jede Füllfläche würde das Teil durchdringen.</translation>
    </message>
    <message>
        <source>Every patch would bulge out too far.</source>
        <translation>Jede Füllfläche würde sich weit vorwölben.</translation>
    </message>
    <message>
        <source>No patch fits, perhaps due to narrow triangles along its boundary. “Repair all” removes them.</source>
        <translation>Keine Füllfläche passt, vielleicht wegen schmaler Dreiecke an seinem Rand. „Alles reparieren“ entfernt sie.</translation>
    </message>
    <message>
        <source>Sharp edge angle</source>
        <translation>Winkel scharfer Kanten</translation>
    </message>
    <message>
        <source>Preserve open edges</source>
        <translation>Offene Kanten erhalten</translation>
    </message>
    <message>
        <source>Prevent self-intersections</source>
        <translation>Selbstdurchdringungen vermeiden</translation>
    </message>
    <message>
        <source>Area and bending</source>
        <translation>Fläche und Knick</translation>
    </message>
    <message>
        <source>Minimum area</source>
        <translation>Kleinste Fläche</translation>
    </message>
    <message>
        <source>Minimum bending</source>
        <translation>Kleinster Knick</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>Stetigkeit</translation>
    </message>
    <message>
        <source>Weight of short edges</source>
        <translation>Gewicht kurzer Kanten</translation>
    </message>
    <message>
        <source>Weight of even angles</source>
        <translation>Gewicht gleichmäßiger Winkel</translation>
    </message>
    <message>
        <source>Weight of small bends</source>
        <translation>Gewicht kleiner Knicke</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Einheit der Datei</translation>
    </message>
    <message>
        <source>Noise angle</source>
        <translation>Rauschwinkel</translation>
    </message>
    <message>
        <source>Move boundary vertices, too</source>
        <translation>Auch Randeckpunkte verschieben</translation>
    </message>
    <message>
        <source>It has no inner edge to split.</source>
        <translation>Er hat innen keine Kante, die sich teilen ließe.</translation>
    </message>
    <message>
        <source>The precision of the file does not allow finer triangles.</source>
        <translation>Die Genauigkeit der Datei erlaubt keine feineren Dreiecke.</translation>
    </message>
    <message>
        <source>New self-intersections</source>
        <translation>Neue Selbstdurchdringungen</translation>
    </message>
    <message>
        <source>The surface now intersects itself here: undo, or smooth it.</source>
        <translation>Die Oberfläche durchdringt sich hier jetzt: Machen Sie es rückgängig, oder glätten Sie sie.</translation>
    </message>
    <message>
        <source>Aspect ratio at the boundary</source>
        <translation>Seitenverhältnis am Rand</translation>
    </message>
    <message>
        <source>Its outer triangles have become long and thin: go back one level.</source>
        <translation>Die äußeren Dreiecke sind lang und schmal geworden: eine Stufe zurückgehen.</translation>
    </message>
    <message>
        <source>Rate control</source>
        <translation>Geschwindigkeitssteuerung</translation>
    </message>
    <message>
        <source>mm/s per mm</source>
        <translation>mm/s für jeden mm</translation>
    </message>
    <message>
        <source>°/s per degree</source>
        <translation>°/s für jedes Grad</translation>
    </message>
    <message>
        <source>Speed and accuracy</source>
        <translation>Geschwindigkeit und Genauigkeit</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Benutzerdefiniert</translation>
    </message>
    <message>
        <source>Hole boundaries as curves</source>
        <translation>Lochränder als Kurven</translation>
    </message>
    <message>
        <source>Clip the model</source>
        <translation>Modell schneiden</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Flip side</source>
        <translation>Seite wechseln</translation>
    </message>
    <message>
        <source>Bounded</source>
        <translation>Begrenzt</translation>
    </message>
    <message>
        <source>Quadric</source>
        <translation>Quadrik</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Scheme</source>
        <translation>Schema</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Loop</translation>
    </message>
    <message>
        <source>√3</source>
        <translation>√3</translation>
    </message>
    <message>
        <source>Butterfly</source>
        <translation>Butterfly</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Noise filter</source>
        <translation>Rauschfilter</translation>
    </message>
    <message>
        <source>Bilateral (preserves edges)</source>
        <translation>Bilateral (erhält Kanten)</translation>
    </message>
    <message>
        <source>Laplace</source>
        <translation>Laplace</translation>
    </message>
    <message>
        <source>Bending</source>
        <translation>Biegung</translation>
    </message>
    <message>
        <source>This filter does not support degenerate or duplicate triangles or edges.</source>
        <translation>Dieser Filter unterstützt keine entarteten oder doppelten Dreiecke oder Kanten.</translation>
    </message>
    <message>
        <source>Resulting triangles</source>
        <translation>Ergebnis: Dreiecke</translation>
    </message>
    <message>
        <source>However thin, the body of the sheet would intersect the part.</source>
        <translation>Der Körper der Fläche würde das Teil durchdringen, so dünn er auch wäre.</translation>
    </message>
    <message>
        <source>The numbers of the file cannot show such a thickness.</source>
        <translation>Die Zahlen der Datei können eine solche Dicke nicht darstellen.</translation>
    </message>
    <message>
        <source>A boundary of the sheet is kept open, and a thin body has none.</source>
        <translation>Ein Rand der Fläche bleibt auf Wunsch offen, und ein dünner Körper hat keinen.</translation>
    </message>
    <message>
        <source>Selected triangles</source>
        <translation>Ausgewählte Dreiecke</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>this figure is not known</source>
        <translation>diese Messgröße ist nicht bekannt</translation>
    </message>
    <message>
        <source>Measured at</source>
        <translation>Gemessen bei</translation>
    </message>
    <message>
        <source>Tolerance on the drawing</source>
        <translation>Toleranz in der Zeichnung</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Untere Grenze</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Obere Grenze</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>No points this far beyond</source>
        <translation>Keine Punkte ab dieser Abweichung</translation>
    </message>
    <message>
        <source>Hidden from students</source>
        <translation>Vor Schülern verborgen</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autor</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Time (min)</source>
        <translation>Zeit (min)</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Lathe</source>
        <translation>Drehmaschine</translation>
    </message>
    <message>
        <source>Spindle speed (r/min)</source>
        <translation>Drehzahl (1/min)</translation>
    </message>
    <message>
        <source>Held by the chuck</source>
        <translation>Einspannlänge im Futter</translation>
    </message>
    <message>
        <source>Diameter of the chuck</source>
        <translation>Durchmesser des Futters</translation>
    </message>
    <message>
        <source>Largest feed (mm per revolution)</source>
        <translation>Größter Vorschub (mm je Umdrehung)</translation>
    </message>
    <message>
        <source>Largest force (N)</source>
        <translation>Größte Kraft (N)</translation>
    </message>
    <message>
        <source>Motor power (kW)</source>
        <translation>Motorleistung (kW)</translation>
    </message>
    <message>
        <source>Midpoint</source>
        <translation>Mittelpunkt</translation>
    </message>
    <message>
        <source>Trainer</source>
        <translation>Trainingsverfahren</translation>
    </message>
    <message>
        <source>Levenberg-Marquardt</source>
        <translation>Levenberg-Marquardt</translation>
    </message>
    <message>
        <source>BFGS</source>
        <translation>BFGS</translation>
    </message>
    <message>
        <source>Scaled conjugate gradient</source>
        <translation>Skalierte konjugierte Gradienten</translation>
    </message>
    <message>
        <source>Gradient descent with momentum</source>
        <translation>Gradientenabstieg mit Impuls</translation>
    </message>
    <message>
        <source>Gradient descent</source>
        <translation>Gradientenabstieg</translation>
    </message>
    <message>
        <source>Feed and radial force</source>
        <translation>Vorschub- und Passivkraft</translation>
    </message>
    <message>
        <source>By depth and nose</source>
        <translation>Nach Schnitttiefe und Eckenradius</translation>
    </message>
    <message>
        <source>Constant share</source>
        <translation>Fester Anteil</translation>
    </message>
    <message>
        <source>Laws of the table</source>
        <translation>Gesetze der Tabelle</translation>
    </message>
    <message>
        <source>Tool material</source>
        <translation>Schneidstoff</translation>
    </message>
    <message>
        <source>Carbide</source>
        <translation>Hartmetall</translation>
    </message>
    <message>
        <source>High-speed steel</source>
        <translation>Schnellarbeitsstahl</translation>
    </message>
    <message>
        <source>Read-out in diameter</source>
        <translation>Anzeige im Durchmesser</translation>
    </message>
    <message>
        <source>Depth limit (0: none)</source>
        <translation>Grenze der Schnitttiefe (0: keine)</translation>
    </message>
    <message>
        <source>Backlash</source>
        <translation>Umkehrspiel</translation>
    </message>
    <message>
        <source>Length in the jaws</source>
        <translation>Einspannlänge in den Backen</translation>
    </message>
    <message>
        <source>Jaws grip inside</source>
        <translation>Backen spannen von innen</translation>
    </message>
    <message>
        <source>In the tailstock</source>
        <translation>Im Reitstock</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Zentrierspitze</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Bohrer</translation>
    </message>
    <message>
        <source>Tailstock at Z</source>
        <translation>Reitstock bei Z</translation>
    </message>
    <message>
        <source>Nominal size</source>
        <translation>Nennmaß</translation>
    </message>
    <message>
        <source>Motor power, kW (0: no limit)</source>
        <translation>Motorleistung, kW (0: unbegrenzt)</translation>
    </message>
    <message>
        <source>Spindle torque, N·m (0: no limit)</source>
        <translation>Spindeldrehmoment, N·m (0: unbegrenzt)</translation>
    </message>
    <message>
        <source>Flank wear of the tools</source>
        <translation>Freiflächenverschleiß der Werkzeuge</translation>
    </message>
    <message>
        <source>Starts</source>
        <translation>Gangzahl</translation>
    </message>
    <message>
        <source>From Z</source>
        <translation>Von Z</translation>
    </message>
    <message>
        <source>To Z</source>
        <translation>Bis Z</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Left-hand</source>
        <translation>Linksgängig</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>Chips are shown</source>
        <translation>Späne werden gezeigt</translation>
    </message>
    <message>
        <source>Diameters and heights to</source>
        <translation>Durchmesser und Höhen auf</translation>
    </message>
    <message>
        <source>Sharp corners instead of radii up to</source>
        <translation>Scharfe Ecken statt Radien bis</translation>
    </message>
    <message>
        <source>SBL</source>
        <translation>SBL</translation>
    </message>
    <message>
        <source>RRTConnect (OMPL)</source>
        <translation>RRTConnect (OMPL)</translation>
    </message>
    <message>
        <source>PRM (OMPL)</source>
        <translation>PRM (OMPL)</translation>
    </message>
    <message>
        <source>Lazy PRM (OMPL)</source>
        <translation>Lazy PRM (OMPL)</translation>
    </message>
    <message>
        <source>SBL (OMPL)</source>
        <translation>SBL (OMPL)</translation>
    </message>
    <message>
        <source>BiTRRT (OMPL)</source>
        <translation>BiTRRT (OMPL)</translation>
    </message>
    <message>
        <source>BKPIECE (OMPL)</source>
        <translation>BKPIECE (OMPL)</translation>
    </message>
    <message>
        <source>EST (OMPL)</source>
        <translation>EST (OMPL)</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Planer</translation>
    </message>
    <message>
        <source>Time limit (s)</source>
        <translation>Zeitgrenze (s)</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Abkürzungen</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>Carried by</source>
        <translation>Getragen von</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Entlang</translation>
    </message>
    <message>
        <source>an edge</source>
        <translation>einer Kante</translation>
    </message>
    <message>
        <source>a section across X</source>
        <translation>eines Schnitts quer zu X</translation>
    </message>
    <message>
        <source>a section across Y</source>
        <translation>eines Schnitts quer zu Y</translation>
    </message>
    <message>
        <source>a section across Z</source>
        <translation>eines Schnitts quer zu Z</translation>
    </message>
    <message>
        <source>Length from there (0: all)</source>
        <translation>Länge von dort (0: alles)</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Vorlauf</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Turn about the tool</source>
        <translation>Drehung um das Werkzeug</translation>
    </message>
    <message>
        <source>Free to turn about the tool</source>
        <translation>Drehung um das Werkzeug ist frei</translation>
    </message>
    <message>
        <source>Distance from the part</source>
        <translation>Abstand vom Teil</translation>
    </message>
    <message>
        <source>Approach and retract</source>
        <translation>An- und Abfahrt</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Geschwindigkeit (mm/s)</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Überschleifen</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>nowhere else</source>
        <translation>nirgends sonst</translation>
    </message>
    <message>
        <source>Comes from</source>
        <translation>Kommt von</translation>
    </message>
    <message>
        <source>Goes to</source>
        <translation>Geht nach</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>simplified: keep a clearance</source>
        <translation>vereinfacht: Abstand halten</translation>
    </message>
    <message>
        <source>Tool centre point, on the flange</source>
        <translation>Werkzeugmittelpunkt, am Flansch</translation>
    </message>
    <message>
        <source>Place of the path</source>
        <translation>Punkt der Bahn</translation>
    </message>
    <message>
        <source>Motion to it</source>
        <translation>Bewegung dorthin</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>über die Gelenke</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>gerade Linie</translation>
    </message>
    <message>
        <source>Speed (%)</source>
        <translation>Geschwindigkeit (%)</translation>
    </message>
    <message>
        <source>First face, at radius</source>
        <translation>Erste Planfläche, bei Radius</translation>
    </message>
    <message>
        <source>First face, near Z</source>
        <translation>Erste Planfläche, nahe Z</translation>
    </message>
    <message>
        <source>Second face, at radius</source>
        <translation>Zweite Planfläche, bei Radius</translation>
    </message>
    <message>
        <source>Second face, near Z</source>
        <translation>Zweite Planfläche, nahe Z</translation>
    </message>
    <message>
        <source>“To Z” must be above “From Z”</source>
        <translation>„Bis Z“ muss über „Von Z“ liegen</translation>
    </message>
    <message>
        <source>the range goes beyond the bar, which begins at Z 0</source>
        <translation>der Bereich geht über die Stange hinaus, die bei Z 0 beginnt</translation>
    </message>
    <message>
        <source>the bar has no face at such a radius</source>
        <translation>die Stange hat keine Planfläche bei einem solchen Radius</translation>
    </message>
    <message>
        <source>there is no face of the bar near such a Z</source>
        <translation>die Stange hat keine Planfläche nahe einem solchen Z</translation>
    </message>
    <message>
        <source>Tools that students may mount; none checked: all</source>
        <translation>Werkzeuge, die Schüler einspannen dürfen; keines angehakt: alle</translation>
    </message>
    <message>
        <source>PRM, kept for the cell</source>
        <translation>PRM, für die Zelle aufbewahrt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Configuration of the arm</source>
        <translation>Stellung des Arms</translation>
    </message>
    <message>
        <source>this pose is out of reach</source>
        <translation>diese Pose ist außer Reichweite</translation>
    </message>
    <message>
        <source>What meets</source>
        <translation>Was zusammenkommt</translation>
    </message>
    <message>
        <source>The points clicked</source>
        <translation>Die angeklickten Punkte</translation>
    </message>
    <message>
        <source>Turn about the normal</source>
        <translation>Drehung um die Normale</translation>
    </message>
    <message>
        <source>The hand leads</source>
        <translation>Die Hand führt</translation>
    </message>
    <message>
        <source>The tool</source>
        <translation>Das Werkzeug</translation>
    </message>
    <message>
        <source>Joint by joint</source>
        <translation>Gelenk für Gelenk</translation>
    </message>
    <message>
        <source>Tool to hand</source>
        <translation>Werkzeug zu Hand</translation>
    </message>
    <message>
        <source>Turns with the hand</source>
        <translation>Dreht sich mit der Hand</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Felt from</source>
        <translation>Fühlbar ab</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Path to follow</source>
        <translation>Zu folgende Bahn</translation>
    </message>
    <message>
        <source>something is in the way</source>
        <translation>etwas ist im Weg</translation>
    </message>
    <message>
        <source>a joint is at its limit</source>
        <translation>ein Gelenk ist an seiner Grenze</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>By eye</source>
        <translation>Nach Augenmaß</translation>
    </message>
    <message>
        <source>With force</source>
        <translation>Mit Kraft</translation>
    </message>
    <message>
        <source>With force and fixture</source>
        <translation>Mit Kraft und Führung</translation>
    </message>
    <message>
        <source>Best of each kind (RMS, largest, time)</source>
        <translation>Bester Versuch jeder Art (RMS, größte, Zeit)</translation>
    </message>
    <message>
        <source>Move by</source>
        <translation>Verschieben um</translation>
    </message>
    <message>
        <source>Turn by</source>
        <translation>Drehen um</translation>
    </message>
    <message>
        <source>Along X</source>
        <translation>Entlang X</translation>
    </message>
    <message>
        <source>Along Y</source>
        <translation>Entlang Y</translation>
    </message>
    <message>
        <source>Along Z</source>
        <translation>Entlang Z</translation>
    </message>
    <message>
        <source>About X</source>
        <translation>Um X</translation>
    </message>
    <message>
        <source>About Y</source>
        <translation>Um Y</translation>
    </message>
    <message>
        <source>About Z</source>
        <translation>Um Z</translation>
    </message>
    <message>
        <source>Of the cell</source>
        <translation>Der Zelle</translation>
    </message>
    <message>
        <source>Turns about</source>
        <translation>Dreht sich um</translation>
    </message>
    <message>
        <source>Its middle</source>
        <translation>Seine Mitte</translation>
    </message>
    <message>
        <source>Its origin</source>
        <translation>Seinen Ursprung</translation>
    </message>
    <message>
        <source>Resolution of the proof</source>
        <translation>Auflösung des Beweises</translation>
    </message>
    <message>
        <source>a drawn curve</source>
        <translation>einer gezeichneten Kurve</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Voxel</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Material (mm³)</source>
        <translation>Material (mm³)</translation>
    </message>
    <message>
        <source>Memory (MB)</source>
        <translation>Arbeitsspeicher (MB)</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>Entstanden aus</translation>
    </message>
    <message>
        <source>Unalloyed steel below 0.25 % C, annealed</source>
        <translation>Unlegierter Stahl unter 0,25 % C, geglüht</translation>
    </message>
    <message>
        <source>Unalloyed steel from 0.25 % C, annealed</source>
        <translation>Unlegierter Stahl ab 0,25 % C, geglüht</translation>
    </message>
    <message>
        <source>Unalloyed steel below 0.55 % C, quenched and tempered</source>
        <translation>Unlegierter Stahl unter 0,55 % C, vergütet</translation>
    </message>
    <message>
        <source>Unalloyed steel from 0.55 % C, annealed</source>
        <translation>Unlegierter Stahl ab 0,55 % C, geglüht</translation>
    </message>
    <message>
        <source>Unalloyed steel from 0.55 % C, quenched and tempered</source>
        <translation>Unlegierter Stahl ab 0,55 % C, vergütet</translation>
    </message>
    <message>
        <source>Low-alloy steel, annealed</source>
        <translation>Niedriglegierter Stahl, geglüht</translation>
    </message>
    <message>
        <source>Low-alloy steel, quenched and tempered, 930 MPa</source>
        <translation>Niedriglegierter Stahl, vergütet, 930 MPa</translation>
    </message>
    <message>
        <source>Low-alloy steel, quenched and tempered, 1000 MPa</source>
        <translation>Niedriglegierter Stahl, vergütet, 1000 MPa</translation>
    </message>
    <message>
        <source>Low-alloy steel, quenched and tempered, 1200 MPa</source>
        <translation>Niedriglegierter Stahl, vergütet, 1200 MPa</translation>
    </message>
    <message>
        <source>High-alloy and tool steel, annealed</source>
        <translation>Hochlegierter Stahl und Werkzeugstahl, geglüht</translation>
    </message>
    <message>
        <source>High-alloy and tool steel, quenched and tempered</source>
        <translation>Hochlegierter Stahl und Werkzeugstahl, vergütet</translation>
    </message>
    <message>
        <source>Stainless steel, ferritic or martensitic</source>
        <translation>Nichtrostender Stahl, ferritisch oder martensitisch</translation>
    </message>
    <message>
        <source>Stainless steel, martensitic</source>
        <translation>Nichtrostender Stahl, martensitisch</translation>
    </message>
    <message>
        <source>Stainless steel, austenitic</source>
        <translation>Nichtrostender Stahl, austenitisch</translation>
    </message>
    <message>
        <source>Grey cast iron, ferritic-pearlitic</source>
        <translation>Grauguss, ferritisch-perlitisch</translation>
    </message>
    <message>
        <source>Grey cast iron, pearlitic</source>
        <translation>Grauguss, perlitisch</translation>
    </message>
    <message>
        <source>Nodular cast iron, ferritic</source>
        <translation>Gusseisen mit Kugelgraphit, ferritisch</translation>
    </message>
    <message>
        <source>Nodular cast iron, pearlitic</source>
        <translation>Gusseisen mit Kugelgraphit, perlitisch</translation>
    </message>
    <message>
        <source>Malleable cast iron, ferritic</source>
        <translation>Temperguss, ferritisch</translation>
    </message>
    <message>
        <source>Malleable cast iron, pearlitic</source>
        <translation>Temperguss, perlitisch</translation>
    </message>
    <message>
        <source>Wrought aluminium alloy</source>
        <translation>Aluminium-Knetlegierung</translation>
    </message>
    <message>
        <source>Wrought aluminium alloy, cured</source>
        <translation>Aluminium-Knetlegierung, ausgehärtet</translation>
    </message>
    <message>
        <source>Cast aluminium alloy to 12 % Si</source>
        <translation>Aluminium-Gusslegierung bis 12 % Si</translation>
    </message>
    <message>
        <source>Cast aluminium alloy to 12 % Si, cured</source>
        <translation>Aluminium-Gusslegierung bis 12 % Si, ausgehärtet</translation>
    </message>
    <message>
        <source>Cast aluminium alloy above 12 % Si</source>
        <translation>Aluminium-Gusslegierung über 12 % Si</translation>
    </message>
    <message>
        <source>Free-cutting copper alloy</source>
        <translation>Kupfer-Automatenlegierung</translation>
    </message>
    <message>
        <source>Brass</source>
        <translation>Messing</translation>
    </message>
    <message>
        <source>Electrolytic copper</source>
        <translation>Elektrolytkupfer</translation>
    </message>
    <message>
        <source>Heat-resistant alloy on iron base, annealed</source>
        <translation>Warmfeste Legierung auf Eisenbasis, geglüht</translation>
    </message>
    <message>
        <source>Heat-resistant alloy on iron base, cured</source>
        <translation>Warmfeste Legierung auf Eisenbasis, ausgehärtet</translation>
    </message>
    <message>
        <source>Heat-resistant alloy on nickel or cobalt base</source>
        <translation>Warmfeste Legierung auf Nickel- oder Kobaltbasis</translation>
    </message>
    <message>
        <source>Pure titanium</source>
        <translation>Reintitan</translation>
    </message>
    <message>
        <source>Titanium alloy, alpha and beta</source>
        <translation>Titanlegierung, Alpha und Beta</translation>
    </message>
    <message>
        <source>Mild steel, 520 MPa</source>
        <translation>Weicher Stahl, 520 MPa</translation>
    </message>
    <message>
        <source>Medium steel, 620 MPa</source>
        <translation>Mittelharter Stahl, 620 MPa</translation>
    </message>
    <message>
        <source>Hard steel, 720 MPa</source>
        <translation>Harter Stahl, 720 MPa</translation>
    </message>
    <message>
        <source>Tool steel, 670 MPa</source>
        <translation>Werkzeugstahl, 670 MPa</translation>
    </message>
    <message>
        <source>Tool steel, 770 MPa</source>
        <translation>Werkzeugstahl, 770 MPa</translation>
    </message>
    <message>
        <source>Chrome-manganese steel, 770 MPa</source>
        <translation>Chrom-Mangan-Stahl, 770 MPa</translation>
    </message>
    <message>
        <source>Chrome-manganese steel, 630 MPa</source>
        <translation>Chrom-Mangan-Stahl, 630 MPa</translation>
    </message>
    <message>
        <source>Chrome-molybdenum steel, 730 MPa</source>
        <translation>Chrom-Molybdän-Stahl, 730 MPa</translation>
    </message>
    <message>
        <source>Chrome-molybdenum steel, 600 MPa</source>
        <translation>Chrom-Molybdän-Stahl, 600 MPa</translation>
    </message>
    <message>
        <source>Nickel-chrome-molybdenum steel, 900 MPa</source>
        <translation>Nickel-Chrom-Molybdän-Stahl, 900 MPa</translation>
    </message>
    <message>
        <source>Nickel-chrome-molybdenum steel, 352 HB</source>
        <translation>Nickel-Chrom-Molybdän-Stahl, 352 HB</translation>
    </message>
    <message>
        <source>Hard cast iron, 46 HRC</source>
        <translation>Hartguss, 46 HRC</translation>
    </message>
    <message>
        <source>Meehanite cast iron, 360 MPa</source>
        <translation>Meehanite-Gusseisen, 360 MPa</translation>
    </message>
    <message>
        <source>Grey cast iron, 200 HB</source>
        <translation>Grauguss, 200 HB</translation>
    </message>
    <message>
        <source>Its own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Process of the path</source>
        <translation>Bearbeitung der Bahn</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Auftragen</translation>
    </message>
    <message>
        <source>Carve</source>
        <translation>Abtragen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Attract</source>
        <translation>Anziehen</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Zusammenziehen</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Depth (mouse)</source>
        <translation>Tiefe (Maus)</translation>
    </message>
    <message>
        <source>Falloff</source>
        <translation>Abfall zum Rand</translation>
    </message>
    <message>
        <source>Mirror across X</source>
        <translation>Spiegeln in X</translation>
    </message>
    <message>
        <source>Mirror across Y</source>
        <translation>Spiegeln in Y</translation>
    </message>
    <message>
        <source>Mirror across Z</source>
        <translation>Spiegeln in Z</translation>
    </message>
    <message>
        <source>Twist drill</source>
        <translation>Spiralbohrer</translation>
    </message>
    <message>
        <source>Spindle (r/min)</source>
        <translation>Spindel (1/min)</translation>
    </message>
    <message>
        <source>Feed by the mouse (mm/s)</source>
        <translation>Vorschub mit der Maus (mm/s)</translation>
    </message>
    <message>
        <source>Thrust (N)</source>
        <translation>Vorschubkraft (N)</translation>
    </message>
    <message>
        <source>Torque (N·mm)</source>
        <translation>Drehmoment (N·mm)</translation>
    </message>
    <message>
        <source>Largest thrust (N)</source>
        <translation>Größte Vorschubkraft (N)</translation>
    </message>
    <message>
        <source>Largest torque (N·mm)</source>
        <translation>Größtes Drehmoment (N·mm)</translation>
    </message>
    <message>
        <source>Removed (mm³)</source>
        <translation>Abgetragen (mm³)</translation>
    </message>
    <message>
        <source>Work (J)</source>
        <translation>Arbeit (J)</translation>
    </message>
    <message>
        <source>Breakthrough after (s)</source>
        <translation>Durchbruch nach (s)</translation>
    </message>
    <message>
        <source>Cycles a second</source>
        <translation>Rechentakte je Sekunde</translation>
    </message>
    <message>
        <source>Erosion</source>
        <translation>Erosion</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>It was the outer boundary of an open sheet.</source>
        <translation>Es war der Außenrand einer offenen Fläche.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Largest parts</source>
        <translation>Größte Teile</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Done when met</source>
        <translation>Erledigt, wenn erfüllt</translation>
    </message>
    <message>
        <source>Planned path</source>
        <translation>Geplante Bahn</translation>
    </message>
    <message>
        <source>Tolerance of the path</source>
        <translation>Toleranz der Bahn</translation>
    </message>
    <message>
        <source>Entry (mm): x; y; z</source>
        <translation>Eintritt (mm): x; y; z</translation>
    </message>
    <message>
        <source>Direction: x; y; z</source>
        <translation>Richtung: x; y; z</translation>
    </message>
    <message>
        <source>Forbidden balls (mm): x; y; z; radius, with | between</source>
        <translation>Verbotene Kugeln (mm): x; y; z; Radius, mit | dazwischen</translation>
    </message>
    <message>
        <source>Drill: ball:6, burr:4 or twist:3</source>
        <translation>Bohrer: ball:6, burr:4 oder twist:3</translation>
    </message>
    <message>
        <source>the target is thicker than the bar</source>
        <translation>das Ziel ist dicker als die Stange</translation>
    </message>
    <message>
        <source>the target is longer than the bar</source>
        <translation>das Ziel ist länger als die Stange</translation>
    </message>
    <message>
        <source>the target goes beyond the chuck&apos;s end of the bar</source>
        <translation>das Ziel ragt über das Ende der Stange im Futter hinaus</translation>
    </message>
    <message>
        <source>the target goes beyond the free end of the bar</source>
        <translation>das Ziel ragt über das freie Ende der Stange hinaus</translation>
    </message>
    <message>
        <source>Left for facing at the free end</source>
        <translation>Aufmaß zum Plandrehen am freien Ende</translation>
    </message>
    <message>
        <source>Finished face, zero of the drawing and programs, Z</source>
        <translation>Fertige Planfläche, Nullpunkt der Zeichnung und der Programme, Z</translation>
    </message>
    <message>
        <source>Left behind the part at the chuck&apos;s end</source>
        <translation>Rest hinter dem Teil am Ende im Futter</translation>
    </message>
    <message>
        <source>Nose radius of the tool</source>
        <translation>Eckenradius des Werkzeugs</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>The outside</source>
        <translation>Außen</translation>
    </message>
    <message>
        <source>A bore</source>
        <translation>Eine Bohrung</translation>
    </message>
    <message>
        <source>The part takes the shape of</source>
        <translation>Das Teil nimmt die Form an</translation>
    </message>
    <message>
        <source>The nose, exactly</source>
        <translation>Der Schneidenecke, genau</translation>
    </message>
    <message>
        <source>A smooth curve near it</source>
        <translation>Einer glatten Kurve nahe daran</translation>
    </message>
    <message>
        <source>Distance of the points of the curve</source>
        <translation>Abstand der Punkte der Kurve</translation>
    </message>
    <message>
        <source>Robot to plan for</source>
        <translation>Roboter, für den geplant wird</translation>
    </message>
    <message>
        <source>they cannot be scored without a limit</source>
        <translation>ohne Grenze können sie nicht vergeben werden</translation>
    </message>
    <message>
        <source>No points at all if not met</source>
        <translation>Gar keine Punkte, wenn nicht erfüllt</translation>
    </message>
    <message>
        <source>the place to measure is missing</source>
        <translation>der Messort fehlt</translation>
    </message>
    <message>
        <source>The centres of the faces</source>
        <translation>Die Mittelpunkte der Flächen</translation>
    </message>
    <message>
        <source>Attracted within</source>
        <translation>Angezogen innerhalb von</translation>
    </message>
    <message>
        <source>Distance behind the hand</source>
        <translation>Abstand hinter der Hand</translation>
    </message>
    <message>
        <source>Opposite direction</source>
        <translation>Entgegengesetzte Richtung</translation>
    </message>
    <message>
        <source>Current position of the robot</source>
        <translation>Jetzige Stellung des Roboters</translation>
    </message>
    <message>
        <source>Edge of a voxel</source>
        <translation>Kantenlänge eines Voxels</translation>
    </message>
    <message>
        <source>Close gaps up to a radius of</source>
        <translation>Lücken schließen bis zum Radius</translation>
    </message>
    <message>
        <source>Memory for the voxels (MB)</source>
        <translation>Arbeitsspeicher für die Voxel (MB)</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>Schale</translation>
    </message>
    <message>
        <source>Move surface</source>
        <translation>Oberfläche versetzen</translation>
    </message>
    <message>
        <source>Combine</source>
        <translation>Kombinieren</translation>
    </message>
    <message>
        <source>Remove debris</source>
        <translation>Bruchstücke entfernen</translation>
    </message>
    <message>
        <source>Close gaps</source>
        <translation>Lücken schließen</translation>
    </message>
    <message>
        <source>Smooth all</source>
        <translation>Alles glätten</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>With</source>
        <translation>Mit</translation>
    </message>
    <message>
        <source>Parts that go</source>
        <translation>Entfallende Teile</translation>
    </message>
    <message>
        <source>Material then (mm³)</source>
        <translation>Material danach (mm³)</translation>
    </message>
    <message>
        <source>Difference (mm³)</source>
        <translation>Differenz (mm³)</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Unite</source>
        <translation>Vereinigung</translation>
    </message>
    <message>
        <source>Subtract</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Intersect</source>
        <translation>Schnittmenge</translation>
    </message>
    <message>
        <source>Smaller than a ball of</source>
        <translation>Kleiner als eine Kugel von</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>All of the surface</source>
        <translation>Alle der Oberfläche</translation>
    </message>
    <message>
        <source>Within a distance</source>
        <translation>Innerhalb eines Abstands</translation>
    </message>
    <message>
        <source>So many</source>
        <translation>So viele</translation>
    </message>
    <message>
        <source>Triangles of the mesh</source>
        <translation>Dreiecke des Netzes</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Marching cubes</source>
        <translation>Marching Cubes</translation>
    </message>
    <message>
        <source>Dual contouring</source>
        <translation>Dual Contouring</translation>
    </message>
    <message>
        <source>Inside the surface</source>
        <translation>Innerhalb der Oberfläche</translation>
    </message>
    <message>
        <source>Outside the surface</source>
        <translation>Außerhalb der Oberfläche</translation>
    </message>
    <message>
        <source>On both sides of it</source>
        <translation>Auf beiden Seiten</translation>
    </message>
    <message>
        <source>Dome</source>
        <translation>Kuppel</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>Pyramide</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>Pebbles</source>
        <translation>Kiesel</translation>
    </message>
    <message>
        <source>Scales</source>
        <translation>Schuppen</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beides</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>Stempel</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Gedreht um</translation>
    </message>
    <message>
        <source>Pressure changes</source>
        <translation>Druck ändert</translation>
    </message>
    <message>
        <source>Drag of a chip 1 mm wide (N·s/mm)</source>
        <translation>Widerstand eines 1 mm breiten Spans (N·s/mm)</translation>
    </message>
    <message>
        <source>Surface area (mm²)</source>
        <translation>Oberfläche (mm²)</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>Places of paths</source>
        <translation>Punkte von Bahnen</translation>
    </message>
    <message>
        <source>Place taken within</source>
        <translation>Punkt gefasst innerhalb von</translation>
    </message>
    <message>
        <source>More than a quarter of the memory</source>
        <translation>Mehr als ein Viertel des Arbeitsspeichers</translation>
    </message>
    <message>
        <source>Smudge</source>
        <translation>Verwischen</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Burr</source>
        <translation>Frässtift</translation>
    </message>
    <message>
        <source>Circular saw</source>
        <translation>Kreissäge</translation>
    </message>
    <message>
        <source>Peck by the mouse (0: none)</source>
        <translation>Spanbruchtiefe mit der Maus (0: keine)</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Size of the voxels</source>
        <translation>Größe der Voxel</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Arbeitsspeicher</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Coordinates and programs</source>
        <translation>Koordinaten und Programme</translation>
    </message>
    <message>
        <source>In the frame</source>
        <translation>Im Bezugssystem</translation>
    </message>
    <message>
        <source>what carried it was removed</source>
        <translation>was es trug, wurde entfernt</translation>
    </message>
    <message>
        <source>Volume of all bodies added up (mm³)</source>
        <translation>Volumen aller Körper zusammengezählt (mm³)</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Memory of the layers (MB)</source>
        <translation>Speicher der Ebenen (MB)</translation>
    </message>
    <message>
        <source>Moves with the frame</source>
        <translation>Bewegt sich mit dem Koordinatensystem</translation>
    </message>
    <message>
        <source>Coordinates in</source>
        <translation>Koordinaten in</translation>
    </message>
    <message>
        <source>the cell</source>
        <translation>der Zelle</translation>
    </message>
    <message>
        <source>Clearance to keep</source>
        <translation>Einzuhaltender Abstand</translation>
    </message>
    <message>
        <source>Programs allowed</source>
        <translation>Programme erlaubt</translation>
    </message>
    <message>
        <source>Cycle time</source>
        <translation>Taktzeit</translation>
    </message>
    <message>
        <source>Security index</source>
        <translation>Sicherheitsindex</translation>
    </message>
    <message>
        <source>Manipulability</source>
        <translation>Manipulierbarkeit</translation>
    </message>
    <message>
        <source>Depth of the hole</source>
        <translation>Tiefe des Lochs</translation>
    </message>
    <message>
        <source>End, at Z</source>
        <translation>Ende, bei Z</translation>
    </message>
    <message>
        <source>Volume that stays in the chuck (mm³)</source>
        <translation>Volumen, das im Futter bleibt (mm³)</translation>
    </message>
    <message>
        <source>Volume parted off (mm³)</source>
        <translation>Abgestochenes Volumen (mm³)</translation>
    </message>
    <message>
        <source>Length parted off (mm)</source>
        <translation>Abgestochene Länge (mm)</translation>
    </message>
    <message>
        <source>Compound slide angle, ° (+: thicker away from the chuck)</source>
        <translation>Winkel des Oberschlittens, ° (+: dicker vom Futter weg)</translation>
    </message>
    <message>
        <source>Failed tries that were undone</source>
        <translation>Gescheiterte Versuche, die rückgängig gemacht wurden</translation>
    </message>
    <message>
        <source>cost the mark of the forbidden region</source>
        <translation>kosten die Punkte des verbotenen Bereichs</translation>
    </message>
    <message>
        <source>fail the work</source>
        <translation>lassen die Arbeit scheitern</translation>
    </message>
    <message>
        <source>are listed only</source>
        <translation>werden nur aufgeführt</translation>
    </message>
    <message>
        <source>it turns to and fro again and again: a section, or a larger tolerance, is smoother</source>
        <translation>sie wendet sich immer wieder hin und her: Ein Schnitt oder eine größere Toleranz ist glatter</translation>
    </message>
    <message>
        <source>Tries</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Commands that cut, such as Thread, allowed</source>
        <translation>Befehle, die spanen, wie Gewinde, erlaubt</translation>
    </message>
    <message>
        <source>Largest resultant force (N)</source>
        <translation>Größte Zerspankraft (N)</translation>
    </message>
    <message>
        <source>no known material: forces are those of a medium carbon steel</source>
        <translation>kein bekannter Werkstoff: die Kräfte sind die eines Stahls mit mittlerem Kohlenstoffgehalt</translation>
    </message>
    <message>
        <source>the limits contradict the class of the thread there: they admit sizes that it refuses</source>
        <translation>die Grenzen widersprechen der Toleranzklasse des Gewindes dort: Sie lassen Maße zu, die sie verwirft</translation>
    </message>
    <message>
        <source>Shapes that could not be read</source>
        <translation>Formen, die nicht gelesen werden konnten</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>nothing is proven free until it is left out or replaced</source>
        <translation>nichts ist als frei bewiesen, bis sie weggelassen oder ersetzt wird</translation>
    </message>
    <message>
        <source>Duration (s), 0: by the speed</source>
        <translation>Dauer (s), 0: nach der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Rounding (CNT, %)</source>
        <translation>Verrundung (CNT, %)</translation>
    </message>
    <message>
        <source>Carries the same after its lines</source>
        <translation>Trägt nach seinen Zeilen dasselbe</translation>
    </message>
    <message>
        <source>Speed of joints without one (per second)</source>
        <translation>Geschwindigkeit von Gelenken ohne Angabe (je Sekunde)</translation>
    </message>
    <message>
        <source>Speed of slides without one (per second)</source>
        <translation>Geschwindigkeit von Schubgelenken ohne Angabe (je Sekunde)</translation>
    </message>
    <message>
        <source>From rest to full speed (s)</source>
        <translation>Aus dem Stand zur vollen Geschwindigkeit (s)</translation>
    </message>
    <message>
        <source>From rest to full acceleration (s)</source>
        <translation>Aus der Ruhe zur vollen Beschleunigung (s)</translation>
    </message>
    <message>
        <source>Assumed for the times of paths</source>
        <translation>Für die Zeiten von Bahnen angenommen</translation>
    </message>
    <message>
        <source>At a device</source>
        <translation>An einem Gerät</translation>
    </message>
    <message>
        <source>Near below</source>
        <translation>Nahe unter</translation>
    </message>
    <message>
        <source>the surface lies in the plane</source>
        <translation>die Fläche liegt in der Ebene</translation>
    </message>
    <message>
        <source>Time for the repair, about (s)</source>
        <translation>Zeit für die Reparatur, etwa (s)</translation>
    </message>
    <message>
        <source>Its triangles touch without a common edge, or more than two share one.</source>
        <translation>Seine Dreiecke berühren sich ohne gemeinsame Kante, oder mehr als zwei teilen sich eine.</translation>
    </message>
    <message>
        <source>It is as fine as its surroundings, and even.</source>
        <translation>Er ist so fein wie seine Umgebung und gleichmäßig.</translation>
    </message>
</context>
<context>
    <name>RepairSummary</name>
    <message numerus="yes">
        <source>%Ln hole(s)</source>
        <translation>
            <numerusform>%Ln Loch</numerusform>
            <numerusform>%Ln Löcher</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln non-manifold edge(s)</source>
        <translation>
            <numerusform>%Ln nicht-mannigfaltige Kante</numerusform>
            <numerusform>%Ln nicht-mannigfaltige Kanten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln non-manifold vertex(ices)</source>
        <translation>
            <numerusform>%Ln nicht-mannigfaltiger Eckpunkt</numerusform>
            <numerusform>%Ln nicht-mannigfaltige Eckpunkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln one-sided edge(s)</source>
        <translation>
            <numerusform>%Ln Kante mit nur einer Seite</numerusform>
            <numerusform>%Ln Kanten mit nur einer Seite</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln body(ies) inside out</source>
        <translation>
            <numerusform>%Ln Körper mit der Innenseite nach außen</numerusform>
            <numerusform>%Ln Körper mit der Innenseite nach außen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of near vertices</source>
        <translation>
            <numerusform>%Ln Paar fast gleicher Eckpunkte</numerusform>
            <numerusform>%Ln Paare fast gleicher Eckpunkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln degenerate triangle(s)</source>
        <translation>
            <numerusform>%Ln entartetes Dreieck</numerusform>
            <numerusform>%Ln entartete Dreiecke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln duplicate triangle(s)</source>
        <translation>
            <numerusform>%Ln doppeltes Dreieck</numerusform>
            <numerusform>%Ln doppelte Dreiecke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln self-intersection(s)</source>
        <translation>
            <numerusform>%Ln Selbstdurchdringung</numerusform>
            <numerusform>%Ln Selbstdurchdringungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln piece(s) of debris</source>
        <translation>
            <numerusform>%Ln Bruchstück</numerusform>
            <numerusform>%Ln Bruchstücke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln reversed triangle(s)</source>
        <translation>
            <numerusform>%Ln umgekehrtes Dreieck</numerusform>
            <numerusform>%Ln umgekehrte Dreiecke</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 corrected</source>
        <translation>%1 von %2 berichtigt</translation>
    </message>
    <message>
        <source>%1 of %2 removed</source>
        <translation>%1 von %2 entfernt</translation>
    </message>
    <message>
        <source>new: %1</source>
        <translation>neu: %1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln outer boundary(ies) and kept hole(s)</source>
        <translation>
            <numerusform>%Ln Außenrand oder offen gelassenes Loch</numerusform>
            <numerusform>%Ln Außenränder und offen gelassene Löcher</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln inconsistent triangle(s)</source>
        <translation>
            <numerusform>%Ln uneinheitliches Dreieck</numerusform>
            <numerusform>%Ln uneinheitliche Dreiecke</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RepairText</name>
    <message>
        <source>Fair</source>
        <translation>Stetig</translation>
    </message>
    <message>
        <source>Refined</source>
        <translation>Verfeinert</translation>
    </message>
    <message>
        <source>Stitched</source>
        <translation>Vernäht</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Entfernt</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>it has more edges than allowed</source>
        <translation>es hat mehr Kanten als erlaubt</translation>
    </message>
    <message>
        <source>colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>normals</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>texture coordinates</source>
        <translation>Texturkoordinaten</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>curves</source>
        <translation>Kurven</translation>
    </message>
    <message numerus="yes">
        <source>%n duplicate triangle(s) removed</source>
        <translation>
            <numerusform>%n doppeltes Dreieck entfernt</numerusform>
            <numerusform>%n doppelte Dreiecke entfernt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) of debris removed</source>
        <translation>
            <numerusform>%n Dreieck von Bruchstücken entfernt</numerusform>
            <numerusform>%n Dreiecke von Bruchstücken entfernt</numerusform>
        </translation>
    </message>
    <message>
        <source>Ridges</source>
        <translation>Grate</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>exact surfaces</source>
        <translation>exakte Flächen</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>not closed</source>
        <translation>nicht geschlossen</translation>
    </message>
    <message>
        <source>manifold</source>
        <translation>mannigfaltig</translation>
    </message>
    <message>
        <source>not manifold</source>
        <translation>nicht mannigfaltig</translation>
    </message>
    <message>
        <source>oriented</source>
        <translation>orientiert</translation>
    </message>
    <message>
        <source>not oriented</source>
        <translation>nicht orientiert</translation>
    </message>
    <message>
        <source>free of self-intersections</source>
        <translation>frei von Selbstdurchdringungen</translation>
    </message>
    <message numerus="yes">
        <source>%n self-intersection(s)</source>
        <translation>
            <numerusform>%n Selbstdurchdringung</numerusform>
            <numerusform>%n Selbstdurchdringungen</numerusform>
        </translation>
    </message>
    <message>
        <source>one piece</source>
        <translation>ein Stück</translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s)</source>
        <translation>
            <numerusform>%n Stück</numerusform>
            <numerusform>%n Stücke</numerusform>
        </translation>
    </message>
    <message>
        <source>Ear clipping</source>
        <translation>Ear-Clipping</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Eben</translation>
    </message>
    <message>
        <source>Thickened sheet</source>
        <translation>Aufgedickte Fläche</translation>
    </message>
    <message>
        <source>Area and bending</source>
        <translation>Fläche und Knick</translation>
    </message>
    <message>
        <source>Minimum area</source>
        <translation>Kleinste Fläche</translation>
    </message>
    <message>
        <source>Minimum bending</source>
        <translation>Kleinster Knick</translation>
    </message>
    <message>
        <source>Triangles as fine as the surroundings, curved to continue them. For scans.</source>
        <translation>Dreiecke so fein wie die Umgebung, gekrümmt, um sie fortzusetzen. Für Scans.</translation>
    </message>
    <message>
        <source>Triangles as fine as the surroundings, not curved. For flat regions.</source>
        <translation>Dreiecke so fein wie die Umgebung, nicht gekrümmt. Für ebene Bereiche.</translation>
    </message>
    <message>
        <source>Cuts off one corner after the other, the best first; adds no vertices. For holes with many edges.</source>
        <translation>Schneidet eine Ecke nach der anderen ab, die beste zuerst; fügt keine Eckpunkte hinzu. Für Löcher mit vielen Kanten.</translation>
    </message>
    <message>
        <source>Small angles between adjacent triangles, then a small area, using edges of the Delaunay tetrahedralisation; adds no vertices.</source>
        <translation>Kleine Winkel zwischen benachbarten Dreiecken, dann kleiner Flächeninhalt, mit Kanten der Delaunay-Tetraeder; fügt keine Eckpunkte hinzu.</translation>
    </message>
    <message>
        <source>Minimises the area; adds no vertices. A hole of more than 300 edges is divided first.</source>
        <translation>Kleinster Flächeninhalt; fügt keine Eckpunkte hinzu. Ein Loch mit mehr als 300 Kanten wird zuerst unterteilt.</translation>
    </message>
    <message>
        <source>Minimises the angles between adjacent triangles, then the area; adds no vertices. A hole of more than 300 edges is divided first.</source>
        <translation>Kleinste Winkel zwischen benachbarten Dreiecken, dann kleinster Flächeninhalt; fügt keine Eckpunkte hinzu. Ein Loch mit mehr als 300 Kanten wird zuerst unterteilt.</translation>
    </message>
    <message>
        <source>As fair, with the sharp edges that end at the hole continued across it. For designed parts.</source>
        <translation>Wie „Glatt“, wobei die scharfen Kanten, die am Loch enden, hindurch fortgesetzt werden. Für konstruierte Teile.</translation>
    </message>
    <message>
        <source>A planar patch in the best-fitting plane of the boundary; adds no vertices. For openings that were cut.</source>
        <translation>Ebene Füllfläche in der Ausgleichsebene des Randes; fügt keine Eckpunkte hinzu. Für geschnittene Öffnungen.</translation>
    </message>
    <message>
        <source>Triangles to one apex behind or in front of the hole.</source>
        <translation>Dreiecke zu einer Spitze hinter oder vor dem Loch.</translation>
    </message>
    <message>
        <source>The sheet was thickened to a thin body.</source>
        <translation>Die Fläche wurde zu einem dünnen Körper aufgedickt.</translation>
    </message>
    <message>
        <source>The boundaries were joined.</source>
        <translation>Die Ränder wurden verbunden.</translation>
    </message>
    <message>
        <source>The triangles around it were removed.</source>
        <translation>Die Dreiecke darum herum wurden entfernt.</translation>
    </message>
    <message>
        <source>it is the outer boundary of an open sheet</source>
        <translation>es ist der Außenrand einer offenen Fläche</translation>
    </message>
    <message>
        <source>it is marked to be kept open</source>
        <translation>es ist als offen zu lassen markiert</translation>
    </message>
    <message>
        <source>no valid patch fits its boundary</source>
        <translation>keine gültige Füllfläche passt auf seinen Rand</translation>
    </message>
    <message>
        <source>every patch would intersect the part</source>
        <translation>jede Füllfläche würde das Teil durchdringen</translation>
    </message>
    <message>
        <source>every patch would bulge out too far</source>
        <translation>jede Füllfläche würde sich weit vorwölben</translation>
    </message>
    <message>
        <source>no patch fits, perhaps due to narrow triangles along its boundary; “Repair all” removes them</source>
        <translation>keine Füllfläche passt, vielleicht wegen schmaler Dreiecke an seinem Rand; „Alles reparieren“ entfernt sie</translation>
    </message>
    <message>
        <source>isolated points</source>
        <translation>einzelne Punkte</translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) reversed</source>
        <translation>
            <numerusform>%n Dreieck umgekehrt</numerusform>
            <numerusform>%n Dreiecke umgekehrt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n degenerate triangle(s) removed</source>
        <translation>
            <numerusform>%n entartetes Dreieck entfernt</numerusform>
            <numerusform>%n entartete Dreiecke entfernt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n dangling triangle(s) removed</source>
        <translation>
            <numerusform>%n lose hängendes Dreieck entfernt</numerusform>
            <numerusform>%n lose hängende Dreiecke entfernt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n near vertex(ices) merged</source>
        <translation>
            <numerusform>%n naher Eckpunkt verschmolzen</numerusform>
            <numerusform>%n nahe Eckpunkte verschmolzen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) cut where patches intersect</source>
        <translation>
            <numerusform>%n Dreieck geschnitten, wo Füllflächen das Teil durchdringen</numerusform>
            <numerusform>%n Dreiecke geschnitten, wo Füllflächen das Teil durchdringen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>self-intersections resolved at %n place(s)</source>
        <translation>
            <numerusform>Selbstdurchdringungen an %n Stelle aufgelöst</numerusform>
            <numerusform>Selbstdurchdringungen an %n Stellen aufgelöst</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s) to be kept open lost with removed triangles</source>
        <translation>
            <numerusform>%n Loch, das offen bleiben sollte, mit entfernten Dreiecken verschwunden</numerusform>
            <numerusform>%n Löcher, die offen bleiben sollten, mit entfernten Dreiecken verschwunden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n folded triangle(s) replaced around holes</source>
        <translation>
            <numerusform>%n gefaltetes Dreieck um Löcher ersetzt</numerusform>
            <numerusform>%n gefaltete Dreiecke um Löcher ersetzt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cut(s) where the surface was one-sided</source>
        <translation>
            <numerusform>%n Schnitt, wo die Oberfläche nur eine Seite hatte</numerusform>
            <numerusform>%n Schnitte, wo die Oberfläche nur eine Seite hatte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n touching vertex(ices) separated</source>
        <translation>
            <numerusform>%n Eckpunkt, an dem sich Teile berührten, getrennt</numerusform>
            <numerusform>%n Eckpunkte, an denen sich Teile berührten, getrennt</numerusform>
        </translation>
    </message>
    <message>
        <source>the patch bends by %1°, its surroundings by at most %2°</source>
        <translation>die Füllfläche knickt um %1°, ihre Umgebung um höchstens %2°</translation>
    </message>
    <message>
        <source>the patch bulges by %1 % of the size of the hole beyond its surroundings</source>
        <translation>die Füllfläche wölbt sich um %1 % der Lochgröße über ihre Umgebung hinaus</translation>
    </message>
    <message>
        <source>further data</source>
        <translation>weitere Daten</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message numerus="yes">
        <source>%n body(ies) inside out reversed</source>
        <translation>
            <numerusform>%n umgestülpter Körper umgekehrt</numerusform>
            <numerusform>%n umgestülpte Körper umgekehrt</numerusform>
        </translation>
    </message>
    <message>
        <source>sheets thickened by %1</source>
        <translation>Flächen um %1 verdickt</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>however thin, the body of the sheet would intersect the part</source>
        <translation>der Körper der Fläche würde das Teil durchdringen, so dünn er auch wäre</translation>
    </message>
    <message>
        <source>the numbers of the file cannot show such a thickness</source>
        <translation>die Zahlen der Datei können eine solche Dicke nicht darstellen</translation>
    </message>
    <message>
        <source>a boundary of the sheet is marked to stay open, and a thin body has none</source>
        <translation>ein Rand der Fläche soll offen bleiben, und ein dünner Körper hat keinen</translation>
    </message>
    <message>
        <source>sheets: %1</source>
        <translation>Flächen: %1</translation>
    </message>
    <message>
        <source>none of %1 thickened</source>
        <translation>keine von %1 verdickt</translation>
    </message>
    <message>
        <source>%1 of %2 thickened by %3</source>
        <translation>%1 von %2 um %3 verdickt</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) left open: %1</source>
        <translation>
            <numerusform>%n Fläche bleibt offen: %1</numerusform>
            <numerusform>%n Flächen bleiben offen: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Outer boundary %1</source>
        <translation>Außenrand %1</translation>
    </message>
    <message>
        <source>Hole %1</source>
        <translation>Loch %1</translation>
    </message>
    <message numerus="yes">
        <source>%1, thinner than requested at %2 of %n vertex(ices)</source>
        <translation>
            <numerusform>%1, an %2 von %n Eckpunkt dünner als verlangt</numerusform>
            <numerusform>%1, an %2 von %n Eckpunkten dünner als verlangt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n hole(s) filled</source>
        <translation>
            <numerusform>%1 von %n Loch gefüllt</numerusform>
            <numerusform>%1 von %n Löchern gefüllt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n kept open</source>
        <translation>
            <numerusform>%n offen gelassen</numerusform>
            <numerusform>%n offen gelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n could not be filled</source>
        <translation>
            <numerusform>%n konnte nicht gefüllt werden</numerusform>
            <numerusform>%n konnten nicht gefüllt werden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>split or joined, %n hole(s) are left</source>
        <translation>
            <numerusform>geteilt oder verbunden, %n Loch bleibt</numerusform>
            <numerusform>geteilt oder verbunden, %n Löcher bleiben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n new opening(s)</source>
        <translation>
            <numerusform>%n neue Öffnung</numerusform>
            <numerusform>%n neue Öffnungen</numerusform>
        </translation>
    </message>
    <message>
        <source>the effort that a mesh of this size allows was used up</source>
        <translation>der Aufwand, den ein Netz dieser Größe zulässt, war verbraucht</translation>
    </message>
    <message>
        <source>it was the outer boundary of an open sheet, which has been changed so that it looks like a hole now</source>
        <translation>es war der Außenrand einer offenen Fläche, die so geändert wurde, dass er jetzt wie ein Loch aussieht</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n outer boundary(ies) closed</source>
        <translation>
            <numerusform>%1 von %n Außenrand geschlossen</numerusform>
            <numerusform>%1 von %n Außenrändern geschlossen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n removed together with other triangles</source>
        <translation>
            <numerusform>%n zusammen mit anderen Dreiecken entfernt</numerusform>
            <numerusform>%n zusammen mit anderen Dreiecken entfernt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n now part of the boundary of an open sheet</source>
        <translation>
            <numerusform>%n jetzt Teil des Rands einer offenen Fläche</numerusform>
            <numerusform>%n jetzt Teil des Rands einer offenen Fläche</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n outer boundary(ies) removed together with other triangles</source>
        <translation>
            <numerusform>%n Außenrand zusammen mit anderen Dreiecken entfernt</numerusform>
            <numerusform>%n Außenränder zusammen mit anderen Dreiecken entfernt</numerusform>
        </translation>
    </message>
    <message>
        <source>bodies that intersect united</source>
        <translation>Körper, die sich durchdringen, vereinigt</translation>
    </message>
    <message>
        <source>A part of the surface that stood out by %1 was removed, at X %2, Y %3, Z %4.</source>
        <translation>Ein Teil der Oberfläche, der %1 herausstand, wurde entfernt, bei X %2, Y %3, Z %4.</translation>
    </message>
    <message>
        <source>The patch spans the hole without continuing the slopes around it; continuing them, it would bulge out or intersect the part.</source>
        <translation>Die Füllfläche überspannt das Loch, ohne die Neigungen ringsum fortzusetzen; sonst würde sie sich hinauswölben oder das Teil durchdringen.</translation>
    </message>
    <message>
        <source>The patch is by “%1”; the chosen method finds no valid patch.</source>
        <translation>Die Füllfläche ist mit „%1“ gemacht; das gewählte Verfahren findet keine gültige.</translation>
    </message>
    <message numerus="yes">
        <source>%n patch(es) not continuing the slopes around</source>
        <translation>
            <numerusform>%n Füllfläche, die die Neigungen ringsum nicht fortsetzt</numerusform>
            <numerusform>%n Füllflächen, die die Neigungen ringsum nicht fortsetzen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n patch(es) by another method than the chosen one</source>
        <translation>
            <numerusform>%n Füllfläche mit einem anderen als dem gewählten Verfahren</numerusform>
            <numerusform>%n Füllflächen mit einem anderen als dem gewählten Verfahren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) of second layers removed</source>
        <translation>
            <numerusform>%n Dreieck einer zweiten Schicht entfernt</numerusform>
            <numerusform>%n Dreiecke zweiter Schichten entfernt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>cracks stitched by moving %n vertex(ices)</source>
        <translation>
            <numerusform>Risse vernäht, dafür %n Eckpunkt verschoben</numerusform>
            <numerusform>Risse vernäht, dafür %n Eckpunkte verschoben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>noise smoothed at %n folded vertex(ices)</source>
        <translation>
            <numerusform>Rauschen an %n gefalteten Eckpunkt geglättet</numerusform>
            <numerusform>Rauschen an %n gefalteten Eckpunkten geglättet</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SubmissionTable</name>
    <message>
        <source>Student</source>
        <translation>Schüler</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Handed in</source>
        <translation>Abgegeben</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>Minuten</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Percent</source>
        <translation>Prozent</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>by program</source>
        <translation>durch ein Programm</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beides</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Hergestellt</translation>
    </message>
    <message>
        <source>Tries</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>by command</source>
        <translation>durch einen Befehl</translation>
    </message>
    <message>
        <source>by hand and command</source>
        <translation>von Hand und durch einen Befehl</translation>
    </message>
    <message>
        <source>by program and command</source>
        <translation>durch ein Programm und einen Befehl</translation>
    </message>
    <message>
        <source>by hand, program and command</source>
        <translation>von Hand, durch ein Programm und einen Befehl</translation>
    </message>
</context>
<context>
    <name>Suggestions</name>
    <message numerus="yes">
        <source>%Ln hole(s) found.</source>
        <translation>
            <numerusform>%Ln Loch gefunden.</numerusform>
            <numerusform>%Ln Löcher gefunden.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 stays open: %2.</source>
        <translation>%1 bleibt offen: %2.</translation>
    </message>
    <message numerus="yes">
        <source>…and %Ln more, see the list.</source>
        <translation>
            <numerusform>… und %Ln weiteres, siehe Liste.</numerusform>
            <numerusform>… und %Ln weitere, siehe Liste.</numerusform>
        </translation>
    </message>
    <message>
        <source>No holes. This is an open sheet.</source>
        <translation>Keine Löcher. Das ist eine offene Fläche.</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>There is nothing to repair.</source>
        <translation>Es gibt nichts zu reparieren.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln hole(s) could not be filled.</source>
        <translation>
            <numerusform>%Ln Loch konnte nicht gefüllt werden.</numerusform>
            <numerusform>%Ln Löcher konnten nicht gefüllt werden.</numerusform>
        </translation>
    </message>
    <message>
        <source>No holes remain except those kept open.</source>
        <translation>Keine Löcher mehr außer den offen gelassenen.</translation>
    </message>
    <message>
        <source>Some defects remain.</source>
        <translation>Einige Fehler sind übrig.</translation>
    </message>
    <message>
        <source>No holes.</source>
        <translation>Keine Löcher.</translation>
    </message>
    <message numerus="yes">
        <source>No holes. These are %Ln open sheet(s).</source>
        <translation>
            <numerusform>Keine Löcher. Dies ist %Ln offene Fläche.</numerusform>
            <numerusform>Keine Löcher. Dies sind %Ln offene Flächen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No holes. %Ln open sheet(s) among %1 pieces.</source>
        <translation>
            <numerusform>Keine Löcher. %Ln offene Fläche unter %1 Stücken.</numerusform>
            <numerusform>Keine Löcher. %Ln offene Flächen unter %1 Stücken.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln open sheet(s).</source>
        <translation>
            <numerusform>%Ln offene Fläche.</numerusform>
            <numerusform>%Ln offene Flächen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The self-intersections stay: %1.</source>
        <translation>Die Selbstdurchdringungen bleiben: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s) reversed on opening.</source>
        <translation>
            <numerusform>%Ln Dreieck beim Öffnen umgedreht.</numerusform>
            <numerusform>%Ln Dreiecke beim Öffnen umgedreht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Closed. Looking for self-intersections…</source>
        <translation>Geschlossen. Selbstdurchdringungen werden gesucht…</translation>
    </message>
    <message numerus="yes">
        <source>…and %Ln more, see the log.</source>
        <translation>
            <numerusform>… und %Ln weiterer, siehe Protokoll.</numerusform>
            <numerusform>… und %Ln weitere, siehe Protokoll.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln hole(s) left.</source>
        <translation>
            <numerusform>%Ln Loch ist übrig.</numerusform>
            <numerusform>%Ln Löcher sind übrig.</numerusform>
        </translation>
    </message>
    <message>
        <source>Outer boundaries of open sheets that the repair changed and that look like holes now: %1. Another repair tries to fill them.</source>
        <translation>Außenränder offener Flächen, die die Reparatur verändert hat und die jetzt wie Löcher aussehen: %1. Eine weitere Reparatur versucht sie zu füllen.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln body(ies) inside another: “Unite bodies” removes what lies inside.</source>
        <translation>
            <numerusform>%Ln Körper liegt in einem anderen: „Körper vereinigen“ entfernt, was innen liegt.</numerusform>
            <numerusform>%Ln Körper liegen in anderen: „Körper vereinigen“ entfernt, was innen liegt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TimingPlot</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Ticks</source>
        <translation>Takte</translation>
    </message>
</context>
<context>
    <name>Tool</name>
    <message>
        <source>second point</source>
        <translation>zweiter Punkt</translation>
    </message>
    <message>
        <source>first point</source>
        <translation>erster Punkt</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>start again</source>
        <translation>neu beginnen</translation>
    </message>
    <message>
        <source>choose a hole</source>
        <translation>Loch wählen</translation>
    </message>
    <message>
        <source>fill the hole</source>
        <translation>Loch füllen</translation>
    </message>
    <message>
        <source>next hole</source>
        <translation>nächstes Loch</translation>
    </message>
    <message>
        <source>previous hole</source>
        <translation>voriges Loch</translation>
    </message>
    <message>
        <source>no longer keep open</source>
        <translation>nicht mehr offen lassen</translation>
    </message>
    <message>
        <source>keep open</source>
        <translation>offen lassen</translation>
    </message>
    <message>
        <source>Selecting by lasso</source>
        <translation>Auswahl mit dem Lasso läuft</translation>
    </message>
    <message>
        <source>select a face or a hole</source>
        <translation>Fläche oder Loch auswählen</translation>
    </message>
    <message>
        <source>paint faces</source>
        <translation>Flächen malen</translation>
    </message>
    <message>
        <source>draw a line around faces</source>
        <translation>Linie um Flächen ziehen</translation>
    </message>
    <message>
        <source>Delete faces</source>
        <translation>Flächen löschen</translation>
    </message>
    <message>
        <source>add to the selection</source>
        <translation>zur Auswahl hinzufügen</translation>
    </message>
    <message>
        <source>smaller brush</source>
        <translation>kleinerer Pinsel</translation>
    </message>
    <message>
        <source>larger brush</source>
        <translation>größerer Pinsel</translation>
    </message>
    <message>
        <source>select all</source>
        <translation>alles auswählen</translation>
    </message>
    <message>
        <source>grow by one ring</source>
        <translation>um einen Ring erweitern</translation>
    </message>
    <message>
        <source>shrink by one ring</source>
        <translation>um einen Ring verkleinern</translation>
    </message>
    <message>
        <source>previous selection</source>
        <translation>vorige Auswahl</translation>
    </message>
    <message>
        <source>next selection</source>
        <translation>nächste Auswahl</translation>
    </message>
    <message>
        <source>delete the faces</source>
        <translation>Flächen löschen</translation>
    </message>
    <message>
        <source>move the joint</source>
        <translation>Gelenk bewegen</translation>
    </message>
    <message>
        <source>pull the whole arm</source>
        <translation>ganzen Arm ziehen</translation>
    </message>
    <message>
        <source>Remove debris</source>
        <translation>Bruchstücke entfernen</translation>
    </message>
    <message>
        <source>third point</source>
        <translation>dritter Punkt</translation>
    </message>
    <message>
        <source>first face</source>
        <translation>erste Fläche</translation>
    </message>
    <message>
        <source>second face</source>
        <translation>zweite Fläche</translation>
    </message>
    <message>
        <source>bridge instead of joining</source>
        <translation>Brücke statt Verbindung</translation>
    </message>
    <message>
        <source>find islands</source>
        <translation>Inseln finden</translation>
    </message>
    <message>
        <source>find peninsulas</source>
        <translation>Halbinseln finden</translation>
    </message>
    <message>
        <source>Remove islands</source>
        <translation>Inseln entfernen</translation>
    </message>
    <message>
        <source>Remove peninsulas</source>
        <translation>Halbinseln entfernen</translation>
    </message>
    <message>
        <source>Remove duplicate triangles</source>
        <translation>Doppelte Dreiecke entfernen</translation>
    </message>
    <message>
        <source>Merge near vertices</source>
        <translation>Fast gleiche Eckpunkte verschmelzen</translation>
    </message>
    <message>
        <source>it would take too long for a mesh of this size</source>
        <translation>das würde für ein Netz dieser Größe zu lange dauern</translation>
    </message>
    <message>
        <source>Cut and close</source>
        <translation>Schneiden und schließen</translation>
    </message>
    <message>
        <source>choose the bridges again</source>
        <translation>Brücken neu wählen lassen</translation>
    </message>
    <message>
        <source>Make a face</source>
        <translation>Fläche erzeugen</translation>
    </message>
    <message>
        <source>first corner, on an open edge</source>
        <translation>erste Ecke, an einer offenen Kante</translation>
    </message>
    <message>
        <source>second corner, counter-clockwise</source>
        <translation>zweite Ecke, gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Smooth surface</source>
        <translation>Oberfläche glätten</translation>
    </message>
    <message>
        <source>Inflate surface</source>
        <translation>Oberfläche aufblähen</translation>
    </message>
    <message>
        <source>Flatten surface</source>
        <translation>Oberfläche ebnen</translation>
    </message>
    <message>
        <source>Drag surface</source>
        <translation>Oberfläche ziehen</translation>
    </message>
    <message>
        <source>Subdivide patch</source>
        <translation>Füllfläche unterteilen</translation>
    </message>
    <message>
        <source>Refine to the surroundings</source>
        <translation>So fein wie die Umgebung unterteilen</translation>
    </message>
    <message>
        <source>Subdividing</source>
        <translation>Füllfläche wird unterteilt</translation>
    </message>
    <message>
        <source>Smoothing noise</source>
        <translation>Rauschen wird geglättet</translation>
    </message>
    <message>
        <source>Smooth noise</source>
        <translation>Rauschen glätten</translation>
    </message>
    <message>
        <source>One level back</source>
        <translation>Eine Stufe zurück</translation>
    </message>
    <message>
        <source>sculpt</source>
        <translation>modellieren</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>glätten</translation>
    </message>
    <message>
        <source>subdivide the patch</source>
        <translation>Füllfläche unterteilen</translation>
    </message>
    <message>
        <source>one level back</source>
        <translation>eine Stufe zurück</translation>
    </message>
    <message>
        <source>refine to the surroundings</source>
        <translation>so fein wie die Umgebung unterteilen</translation>
    </message>
    <message>
        <source>sculpt a coarser level</source>
        <translation>gröbere Stufe modellieren</translation>
    </message>
    <message>
        <source>sculpt a finer level</source>
        <translation>feinere Stufe modellieren</translation>
    </message>
    <message>
        <source>smooth the noise of the patch</source>
        <translation>Rauschen der Füllfläche glätten</translation>
    </message>
    <message>
        <source>smooth the noise along the holes</source>
        <translation>Rauschen entlang der Löcher glätten</translation>
    </message>
    <message>
        <source>sculpt the whole surface</source>
        <translation>ganze Oberfläche modellieren</translation>
    </message>
    <message>
        <source>centre on the origin</source>
        <translation>im Ursprung zentrieren</translation>
    </message>
    <message>
        <source>Centre on the origin</source>
        <translation>Im Ursprung zentrieren</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Platzieren</translation>
    </message>
    <message>
        <source>coordinates would become too large</source>
        <translation>die Koordinaten würden zu groß</translation>
    </message>
    <message>
        <source>reset</source>
        <translation>zurücksetzen</translation>
    </message>
    <message>
        <source>Add a mesh</source>
        <translation>Netz hinzufügen</translation>
    </message>
    <message>
        <source>join instead of bridging</source>
        <translation>verbinden statt überbrücken</translation>
    </message>
    <message>
        <source>Fill hole</source>
        <translation>Loch füllen</translation>
    </message>
    <message>
        <source>Change the unit</source>
        <translation>Einheit ändern</translation>
    </message>
    <message>
        <source>Repair all</source>
        <translation>Alles reparieren</translation>
    </message>
    <message>
        <source>Sculpt</source>
        <translation>Modellieren</translation>
    </message>
    <message>
        <source>cut a pass</source>
        <translation>einen Schnitt ausführen</translation>
    </message>
    <message>
        <source>remove the body</source>
        <translation>Körper entfernen</translation>
    </message>
    <message>
        <source>select a body</source>
        <translation>Körper auswählen</translation>
    </message>
    <message>
        <source>Change bodies</source>
        <translation>Körper ändern</translation>
    </message>
    <message>
        <source>move the joint or the body</source>
        <translation>Gelenk oder Körper bewegen</translation>
    </message>
    <message>
        <source>pull the whole arm, or move the body up and down</source>
        <translation>den ganzen Arm ziehen oder den Körper auf und ab bewegen</translation>
    </message>
    <message>
        <source>move the body without snapping</source>
        <translation>den Körper ohne Einrasten bewegen</translation>
    </message>
    <message>
        <source>deselect the body</source>
        <translation>Auswahl des Körpers aufheben</translation>
    </message>
    <message>
        <source>the mesh has no more triangles than that</source>
        <translation>das Netz hat nicht mehr Dreiecke als das</translation>
    </message>
    <message>
        <source>a job that changes this mesh is running</source>
        <translation>ein Auftrag, der dieses Netz ändert, läuft</translation>
    </message>
    <message>
        <source>no piece is far smaller than the largest</source>
        <translation>kein Stück ist viel kleiner als das größte</translation>
    </message>
    <message>
        <source>move the body</source>
        <translation>den Körper bewegen</translation>
    </message>
    <message>
        <source>move the body up and down</source>
        <translation>den Körper auf und ab bewegen</translation>
    </message>
    <message>
        <source>Thicken sheets</source>
        <translation>Flächen aufdicken</translation>
    </message>
    <message>
        <source>Separate touching parts</source>
        <translation>Berührende Teile trennen</translation>
    </message>
    <message>
        <source>Make two-sided</source>
        <translation>Zweiseitig machen</translation>
    </message>
    <message>
        <source>Reverse faces</source>
        <translation>Flächen umkehren</translation>
    </message>
    <message>
        <source>Resolve self-intersections</source>
        <translation>Selbstdurchdringungen auflösen</translation>
    </message>
    <message>
        <source>cancel the move</source>
        <translation>Verschiebung abbrechen</translation>
    </message>
    <message>
        <source>keep this measurement</source>
        <translation>diese Messung behalten</translation>
    </message>
    <message>
        <source>the boundary has changed meanwhile</source>
        <translation>der Rand hat sich inzwischen geändert</translation>
    </message>
    <message>
        <source>not possible: two of the vertices are the same</source>
        <translation>nicht möglich: zwei der Eckpunkte sind dieselben</translation>
    </message>
    <message>
        <source>not possible: a triangle would flip or become degenerate</source>
        <translation>nicht möglich: ein Dreieck würde umklappen oder entarten</translation>
    </message>
    <message>
        <source>not possible: an edge would have more than two triangles</source>
        <translation>nicht möglich: eine Kante hätte mehr als zwei Dreiecke</translation>
    </message>
    <message>
        <source>not possible: the adjacent triangle has the opposite orientation</source>
        <translation>nicht möglich: das benachbarte Dreieck ist entgegengesetzt orientiert</translation>
    </message>
    <message>
        <source>not possible: it would touch the surface at a single vertex only</source>
        <translation>nicht möglich: es würde die Oberfläche nur an einem Eckpunkt berühren</translation>
    </message>
    <message>
        <source>not possible: it would intersect or touch the part</source>
        <translation>nicht möglich: es würde das Teil durchdringen oder berühren</translation>
    </message>
    <message>
        <source>not possible: there is no open edge</source>
        <translation>nicht möglich: es gibt keine offene Kante</translation>
    </message>
    <message>
        <source>smooth the boundary</source>
        <translation>Rand glätten</translation>
    </message>
    <message>
        <source>deselect the hole</source>
        <translation>Lochauswahl aufheben</translation>
    </message>
    <message>
        <source>move the vertex</source>
        <translation>Eckpunkt verschieben</translation>
    </message>
    <message>
        <source>move the vertex as far as possible</source>
        <translation>Eckpunkt so weit wie möglich verschieben</translation>
    </message>
    <message>
        <source>join the vertices</source>
        <translation>Eckpunkte verbinden</translation>
    </message>
    <message>
        <source>not possible: no other vertex is near</source>
        <translation>nicht möglich: kein anderer Eckpunkt ist in der Nähe</translation>
    </message>
    <message>
        <source>add the bridge</source>
        <translation>Brücke hinzufügen</translation>
    </message>
    <message>
        <source>drag a vertex; onto another one: join them</source>
        <translation>Eckpunkt ziehen; auf einen anderen: verbinden</translation>
    </message>
    <message>
        <source>add a bridge to another vertex</source>
        <translation>Brücke zu einem anderen Eckpunkt hinzufügen</translation>
    </message>
    <message>
        <source>do not snap</source>
        <translation>nicht fangen</translation>
    </message>
    <message>
        <source>apply the smoothed boundary</source>
        <translation>geglätteten Rand übernehmen</translation>
    </message>
    <message>
        <source>remove the marked triangles</source>
        <translation>markierte Dreiecke entfernen</translation>
    </message>
    <message>
        <source>leave it unchanged</source>
        <translation>unverändert lassen</translation>
    </message>
    <message>
        <source>choose a boundary</source>
        <translation>Rand wählen</translation>
    </message>
    <message>
        <source>Analysing the boundary</source>
        <translation>Rand wird untersucht</translation>
    </message>
    <message>
        <source>reduce triangles</source>
        <translation>Dreiecke reduzieren</translation>
    </message>
    <message>
        <source>they are the two sides of a plate of zero thickness, which is closed</source>
        <translation>sie sind die zwei Seiten einer Platte ohne Dicke, die geschlossen ist</translation>
    </message>
    <message>
        <source>every separation would make the surface intersect itself</source>
        <translation>jede Trennung würde eine Selbstdurchdringung der Oberfläche verursachen</translation>
    </message>
    <message>
        <source>the cut could not be closed without intersecting the part</source>
        <translation>der Schnitt ließe sich nicht schließen, ohne das Teil zu durchdringen</translation>
    </message>
    <message>
        <source>the region to be cut is folded too much</source>
        <translation>der zu schneidende Bereich ist zu stark gefaltet</translation>
    </message>
    <message>
        <source>bridge the hole from vertex to vertex</source>
        <translation>Loch von Eckpunkt zu Eckpunkt überbrücken</translation>
    </message>
    <message>
        <source>undo the last corner</source>
        <translation>letzte Ecke zurücknehmen</translation>
    </message>
    <message>
        <source>no triangle can be removed within the given limits</source>
        <translation>innerhalb der gegebenen Grenzen kann kein Dreieck entfernt werden</translation>
    </message>
    <message>
        <source>Reduce triangles</source>
        <translation>Dreiecke reduzieren</translation>
    </message>
    <message>
        <source>Add a bridge</source>
        <translation>Brücke hinzufügen</translation>
    </message>
    <message>
        <source>Join boundary vertices</source>
        <translation>Randeckpunkte verbinden</translation>
    </message>
    <message>
        <source>Move a boundary vertex</source>
        <translation>Randeckpunkt verschieben</translation>
    </message>
    <message>
        <source>Smooth the boundary</source>
        <translation>Rand glätten</translation>
    </message>
    <message>
        <source>Remove degenerate triangles</source>
        <translation>Entartete Dreiecke entfernen</translation>
    </message>
    <message>
        <source>place on the largest flat face</source>
        <translation>auf die größte ebene Fläche stellen</translation>
    </message>
    <message>
        <source>Place on the largest flat face</source>
        <translation>Auf die größte ebene Fläche stellen</translation>
    </message>
    <message>
        <source>align the principal axes</source>
        <translation>Hauptachsen ausrichten</translation>
    </message>
    <message>
        <source>Align the principal axes</source>
        <translation>Hauptachsen ausrichten</translation>
    </message>
    <message>
        <source>move the minimum corner to the origin</source>
        <translation>kleinste Ecke in den Ursprung verschieben</translation>
    </message>
    <message>
        <source>Move the minimum corner to the origin</source>
        <translation>Kleinste Ecke in den Ursprung verschieben</translation>
    </message>
    <message>
        <source>opposite direction</source>
        <translation>Gegenrichtung</translation>
    </message>
    <message>
        <source>undo: the surface now intersects itself</source>
        <translation>rückgängig: die Oberfläche durchdringt sich jetzt</translation>
    </message>
    <message>
        <source>invert the selection</source>
        <translation>Auswahl umkehren</translation>
    </message>
    <message>
        <source>reverse the shells of the selected faces</source>
        <translation>Schalen der ausgewählten Flächen umkehren</translation>
    </message>
    <message>
        <source>clear the selection</source>
        <translation>Auswahl aufheben</translation>
    </message>
    <message>
        <source>select connected faces</source>
        <translation>zusammenhängende Flächen auswählen</translation>
    </message>
    <message>
        <source>select up to the next sharp edge</source>
        <translation>bis zur nächsten scharfen Kante auswählen</translation>
    </message>
    <message>
        <source>Selecting up to the next sharp edge</source>
        <translation>Auswahl bis zur nächsten scharfen Kante läuft</translation>
    </message>
    <message>
        <source>Selecting connected faces</source>
        <translation>Zusammenhängende Flächen werden ausgewählt</translation>
    </message>
    <message>
        <source>remove from the selection</source>
        <translation>aus der Auswahl entfernen</translation>
    </message>
    <message>
        <source>apply the placement</source>
        <translation>Platzierung anwenden</translation>
    </message>
    <message>
        <source>discard the pass</source>
        <translation>Schnitt verwerfen</translation>
    </message>
    <message>
        <source>the pass is full: release it</source>
        <translation>der Schnitt ist voll: loslassen</translation>
    </message>
    <message>
        <source>third corner: creates the face</source>
        <translation>dritte Ecke: erzeugt die Fläche</translation>
    </message>
    <message>
        <source>a boundary of the sheet is marked to stay open, and a thin body has none</source>
        <translation>ein Rand der Fläche soll offen bleiben, und ein dünner Körper hat keinen</translation>
    </message>
    <message>
        <source>no cut would separate the triangles cleanly</source>
        <translation>kein Schnitt würde die Dreiecke sauber trennen</translation>
    </message>
    <message>
        <source>no body is inside out</source>
        <translation>kein Körper ist umgestülpt</translation>
    </message>
    <message>
        <source>however thin, the body would intersect the part</source>
        <translation>der Körper würde das Teil durchdringen, wie dünn er auch ist</translation>
    </message>
    <message>
        <source>a triangle has a repeated vertex: remove degenerate triangles first</source>
        <translation>ein Dreieck hat einen Eckpunkt doppelt: Entfernen Sie zuerst entartete Dreiecke</translation>
    </message>
    <message>
        <source>more than two triangles share an edge: the surface would tear there</source>
        <translation>mehr als zwei Dreiecke teilen eine Kante: Dort würde die Oberfläche reißen</translation>
    </message>
    <message>
        <source>a vertex has too many triangles for this scheme: choose another</source>
        <translation>ein Eckpunkt hat zu viele Dreiecke für dieses Schema: Wählen Sie ein anderes</translation>
    </message>
    <message>
        <source>the result would have too many triangles</source>
        <translation>das Ergebnis hätte zu viele Dreiecke</translation>
    </message>
    <message>
        <source>the precision of the file does not allow finer triangles</source>
        <translation>die Genauigkeit der Datei erlaubt keine feineren Dreiecke</translation>
    </message>
    <message>
        <source>Subdivide the mesh</source>
        <translation>Netz unterteilen</translation>
    </message>
    <message>
        <source>it is already in place</source>
        <translation>es ist bereits dort</translation>
    </message>
    <message>
        <source>it has no area</source>
        <translation>es hat keinen Flächeninhalt</translation>
    </message>
    <message>
        <source>there is no flat face that the part can stand on</source>
        <translation>es gibt keine ebene Fläche, auf der das Teil stehen kann</translation>
    </message>
    <message>
        <source>subdivide the mesh</source>
        <translation>das Netz unterteilen</translation>
    </message>
    <message>
        <source>the numbers of the file cannot show such a thickness</source>
        <translation>die Zahlen der Datei können eine solche Dicke nicht darstellen</translation>
    </message>
    <message>
        <source>no cut would separate the triangles cleanly; “Repair all” may replace them together with a hole</source>
        <translation>kein Schnitt würde die Dreiecke sauber trennen; „Alles reparieren“ ersetzt sie vielleicht zusammen mit einem Loch</translation>
    </message>
    <message>
        <source>Train a force model</source>
        <translation>Ein Kraftmodell trainieren</translation>
    </message>
    <message>
        <source>Cutting force</source>
        <translation>Schnittkraft</translation>
    </message>
    <message>
        <source>Set up the lathe</source>
        <translation>Drehmaschine einrichten</translation>
    </message>
    <message>
        <source>carriage to the chuck</source>
        <translation>Bettschlitten zum Futter</translation>
    </message>
    <message>
        <source>carriage away</source>
        <translation>Bettschlitten vom Futter weg</translation>
    </message>
    <message>
        <source>carriage by ten divisions to the chuck</source>
        <translation>Bettschlitten um zehn Teilstriche zum Futter</translation>
    </message>
    <message>
        <source>carriage by ten divisions away</source>
        <translation>Bettschlitten um zehn Teilstriche vom Futter weg</translation>
    </message>
    <message>
        <source>cross slide in</source>
        <translation>Planschlitten hinein</translation>
    </message>
    <message>
        <source>cross slide out</source>
        <translation>Planschlitten heraus</translation>
    </message>
    <message>
        <source>cross slide by ten divisions in</source>
        <translation>Planschlitten um zehn Teilstriche hinein</translation>
    </message>
    <message>
        <source>cross slide by ten divisions out</source>
        <translation>Planschlitten um zehn Teilstriche heraus</translation>
    </message>
    <message>
        <source>compound slide in</source>
        <translation>Oberschlitten hinein</translation>
    </message>
    <message>
        <source>compound slide out</source>
        <translation>Oberschlitten heraus</translation>
    </message>
    <message>
        <source>start or stop the spindle</source>
        <translation>Spindel starten oder anhalten</translation>
    </message>
    <message>
        <source>turn the tool post</source>
        <translation>Stahlhalter drehen</translation>
    </message>
    <message>
        <source>stop the lathe</source>
        <translation>Drehmaschine anhalten</translation>
    </message>
    <message>
        <source>move the tool</source>
        <translation>das Werkzeug bewegen</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>move the carriage</source>
        <translation>den Bettschlitten bewegen</translation>
    </message>
    <message>
        <source>move the cross slide</source>
        <translation>den Planschlitten bewegen</translation>
    </message>
    <message>
        <source>move the compound slide</source>
        <translation>den Oberschlitten bewegen</translation>
    </message>
    <message>
        <source>by ten divisions</source>
        <translation>um zehn Teilstriche</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Gewinde</translation>
    </message>
    <message>
        <source>separating all of them would take too long for a mesh of this size</source>
        <translation>alle zu trennen würde für ein Netz dieser Größe zu lange dauern</translation>
    </message>
    <message>
        <source>“Repair all” leaves them as they are; they can be fixed here</source>
        <translation>„Alles reparieren“ lässt sie, wie sie sind; hier lassen sie sich berichtigen</translation>
    </message>
    <message>
        <source>merging them would make edges with more than two triangles</source>
        <translation>zusammengeführt ergäben sie Kanten mit mehr als zwei Dreiecken</translation>
    </message>
    <message>
        <source>a boundary that is to stay open goes through it</source>
        <translation>ein Rand, der offen bleiben soll, verläuft hindurch</translation>
    </message>
    <message>
        <source>it takes a cut longer than a hundredth of the model, which “Repair all” does not make; it can be made here</source>
        <translation>es braucht einen Schnitt, der länger als ein Hundertstel des Modells ist; „Alles reparieren“ macht ihn nicht, hier ist er möglich</translation>
    </message>
    <message>
        <source>the cut would begin and end at an open edge, which “Repair all” does not make; it can be made here</source>
        <translation>der Schnitt würde an einer offenen Kante beginnen und enden; „Alles reparieren“ macht ihn nicht, hier ist er möglich</translation>
    </message>
    <message>
        <source>by a tenth of a division</source>
        <translation>um ein Zehntel eines Teilstrichs</translation>
    </message>
    <message>
        <source>rapid traverse while held</source>
        <translation>Eilgang, solange gedrückt</translation>
    </message>
    <message>
        <source>carriage by a tenth of a division to the chuck</source>
        <translation>Bettschlitten um ein Zehntel eines Teilstrichs zum Futter</translation>
    </message>
    <message>
        <source>carriage by a tenth of a division away</source>
        <translation>Bettschlitten um ein Zehntel eines Teilstrichs vom Futter weg</translation>
    </message>
    <message>
        <source>carriage rapidly to the chuck, while held</source>
        <translation>Bettschlitten im Eilgang zum Futter, solange gedrückt</translation>
    </message>
    <message>
        <source>carriage rapidly away, while held</source>
        <translation>Bettschlitten im Eilgang vom Futter weg, solange gedrückt</translation>
    </message>
    <message>
        <source>cross slide by a tenth of a division in</source>
        <translation>Planschlitten um ein Zehntel eines Teilstrichs nach innen</translation>
    </message>
    <message>
        <source>cross slide by a tenth of a division out</source>
        <translation>Planschlitten um ein Zehntel eines Teilstrichs nach außen</translation>
    </message>
    <message>
        <source>cross slide rapidly in, while held</source>
        <translation>Planschlitten im Eilgang nach innen, solange gedrückt</translation>
    </message>
    <message>
        <source>cross slide rapidly out, while held</source>
        <translation>Planschlitten im Eilgang nach außen, solange gedrückt</translation>
    </message>
    <message>
        <source>Mount %1</source>
        <translation>%1 einspannen</translation>
    </message>
    <message>
        <source>Take the tool off</source>
        <translation>Werkzeug ausspannen</translation>
    </message>
    <message>
        <source>Round the target</source>
        <translation>Ziel runden</translation>
    </message>
    <message>
        <source>Inverse kinematics</source>
        <translation>Inverse Kinematik</translation>
    </message>
    <message>
        <source>Planning benchmark</source>
        <translation>Vergleich der Bahnplanung</translation>
    </message>
    <message>
        <source>Configuration</source>
        <translation>Stellung</translation>
    </message>
    <message>
        <source>Plan path</source>
        <translation>Bahn planen</translation>
    </message>
    <message>
        <source>Plan process path</source>
        <translation>Bearbeitungsbahn planen</translation>
    </message>
    <message>
        <source>plan the path along the curve</source>
        <translation>die Bahn entlang der Kurve planen</translation>
    </message>
    <message>
        <source>choose another curve</source>
        <translation>eine andere Kurve wählen</translation>
    </message>
    <message>
        <source>choose a curve on a part</source>
        <translation>eine Kurve auf einem Teil wählen</translation>
    </message>
    <message>
        <source>next way</source>
        <translation>nächste Stellung</translation>
    </message>
    <message>
        <source>previous way</source>
        <translation>vorige Stellung</translation>
    </message>
    <message>
        <source>move the robot there</source>
        <translation>Roboter dorthin bewegen</translation>
    </message>
    <message>
        <source>the cell is being prepared</source>
        <translation>die Zelle wird vorbereitet</translation>
    </message>
    <message>
        <source>this pose is out of reach</source>
        <translation>diese Pose ist außer Reichweite</translation>
    </message>
    <message>
        <source>a joint would be beyond its limits</source>
        <translation>ein Gelenk wäre außerhalb seiner Grenzen</translation>
    </message>
    <message>
        <source>place the body there</source>
        <translation>Körper dort platzieren</translation>
    </message>
    <message>
        <source>choose another face</source>
        <translation>andere Fläche wählen</translation>
    </message>
    <message>
        <source>choose a face of the body to be placed</source>
        <translation>Fläche des zu platzierenden Körpers wählen</translation>
    </message>
    <message>
        <source>click a face of the body to be placed</source>
        <translation>Fläche des zu platzierenden Körpers anklicken</translation>
    </message>
    <message>
        <source>add this place to the path</source>
        <translation>diesen Punkt zur Bahn hinzufügen</translation>
    </message>
    <message>
        <source>lead the robot&apos;s tool</source>
        <translation>Werkzeug des Roboters führen</translation>
    </message>
    <message>
        <source>turn the robot&apos;s tool</source>
        <translation>Werkzeug des Roboters drehen</translation>
    </message>
    <message>
        <source>Optimise path</source>
        <translation>Bahn optimieren</translation>
    </message>
    <message>
        <source>nothing is typed</source>
        <translation>es ist nichts eingegeben</translation>
    </message>
    <message>
        <source>remove the last point</source>
        <translation>letzten Punkt entfernen</translation>
    </message>
    <message>
        <source>draw the curve to there</source>
        <translation>Kurve bis dorthin zeichnen</translation>
    </message>
    <message>
        <source>begin a curve on a part</source>
        <translation>eine Kurve auf einem Teil beginnen</translation>
    </message>
    <message>
        <source>draw in one go</source>
        <translation>in einem Zug zeichnen</translation>
    </message>
    <message>
        <source>too fast: feed %1 mm/rev, at most %2</source>
        <translation>zu schnell: Vorschub %1 mm/U, höchstens %2</translation>
    </message>
    <message>
        <source>Change robots</source>
        <translation>Roboter ändern</translation>
    </message>
    <message>
        <source>Make volume</source>
        <translation>Volumen erzeugen</translation>
    </message>
    <message>
        <source>Make mesh</source>
        <translation>Netz erzeugen</translation>
    </message>
    <message>
        <source>place it there</source>
        <translation>dort platzieren</translation>
    </message>
    <message>
        <source>move it without snapping</source>
        <translation>ohne Einrasten bewegen</translation>
    </message>
    <message>
        <source>add clay</source>
        <translation>Ton auftragen</translation>
    </message>
    <message>
        <source>carve</source>
        <translation>abtragen</translation>
    </message>
    <message>
        <source>move clay along</source>
        <translation>Ton mitziehen</translation>
    </message>
    <message>
        <source>discard the stroke</source>
        <translation>Strich verwerfen</translation>
    </message>
    <message>
        <source>Add clay</source>
        <translation>Ton auftragen</translation>
    </message>
    <message>
        <source>Carve clay</source>
        <translation>Ton abtragen</translation>
    </message>
    <message>
        <source>Inflate clay</source>
        <translation>Ton aufblähen</translation>
    </message>
    <message>
        <source>Smooth clay</source>
        <translation>Ton glätten</translation>
    </message>
    <message>
        <source>Flatten clay</source>
        <translation>Ton ebnen</translation>
    </message>
    <message>
        <source>Move clay</source>
        <translation>Ton verschieben</translation>
    </message>
    <message>
        <source>Attract clay</source>
        <translation>Ton anziehen</translation>
    </message>
    <message>
        <source>Pinch clay</source>
        <translation>Ton zusammenziehen</translation>
    </message>
    <message>
        <source>%1: %2 mm³</source>
        <translation>%1: %2 mm³</translation>
    </message>
    <message>
        <source>shape the clay</source>
        <translation>Ton formen</translation>
    </message>
    <message>
        <source>discard the hole</source>
        <translation>Bohrung verwerfen</translation>
    </message>
    <message>
        <source>Drill: −%1 mm³, at most %2 N and %3 N·mm</source>
        <translation>Bohren: −%1 mm³, höchstens %2 N und %3 N·mm</translation>
    </message>
    <message>
        <source>breakthrough: release the button</source>
        <translation>Durchbruch: Taste loslassen</translation>
    </message>
    <message>
        <source>drill across the surface</source>
        <translation>senkrecht zur Oberfläche bohren</translation>
    </message>
    <message>
        <source>drill along the view</source>
        <translation>in Blickrichtung bohren</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>Turning pass %1</source>
        <translation>Drehschnitt %1</translation>
    </message>
    <message>
        <source>Segment image</source>
        <translation>Bild segmentieren</translation>
    </message>
    <message>
        <source>OpenMesh does not support two edges between the same vertices, as on one-sided surfaces: repair the mesh first</source>
        <translation>OpenMesh unterstützt keine zwei Kanten zwischen denselben Eckpunkten, wie auf Flächen mit nur einer Seite: Reparieren Sie zuerst das Netz</translation>
    </message>
    <message>
        <source>OpenMesh does not support two triangles back to back, a plate of zero thickness: delete them first</source>
        <translation>OpenMesh unterstützt keine zwei Dreiecke Rücken an Rücken, eine Platte der Dicke null: Löschen Sie sie zuerst</translation>
    </message>
    <message>
        <source>in the forbidden region: release the button</source>
        <translation>im verbotenen Bereich: Taste loslassen</translation>
    </message>
    <message>
        <source>beside the planned path</source>
        <translation>neben der geplanten Bahn</translation>
    </message>
    <message>
        <source>back to the current pose of the robot</source>
        <translation>zurück zur jetzigen Stellung des Roboters</translation>
    </message>
    <message>
        <source>the robot is already in this configuration</source>
        <translation>der Roboter steht schon in dieser Stellung</translation>
    </message>
    <message>
        <source>move a robot by its base</source>
        <translation>einen Roboter an seiner Basis bewegen</translation>
    </message>
    <message>
        <source>choose the face to place it on</source>
        <translation>Fläche wählen, auf die er gelegt werden soll</translation>
    </message>
    <message>
        <source>click the face to place it on</source>
        <translation>Fläche anklicken, auf die er gelegt werden soll</translation>
    </message>
    <message>
        <source>move a body or a robot&apos;s base over the floor, along an arrow, turn by a ring</source>
        <translation>einen Körper oder die Basis eines Roboters über den Boden oder entlang eines Pfeils bewegen, an einem Ring drehen</translation>
    </message>
    <message>
        <source>move it up and down</source>
        <translation>auf und ab bewegen</translation>
    </message>
    <message>
        <source>there are no triangles, or they have coordinates that are not numbers</source>
        <translation>es gibt keine Dreiecke, oder ihre Koordinaten sind keine Zahlen</translation>
    </message>
    <message>
        <source>Repair by volume</source>
        <translation>Volumetrisch reparieren</translation>
    </message>
    <message>
        <source>repair by volume</source>
        <translation>volumetrisch reparieren</translation>
    </message>
    <message>
        <source>apply</source>
        <translation>anwenden</translation>
    </message>
    <message>
        <source>combine with a file</source>
        <translation>mit einer Datei kombinieren</translation>
    </message>
    <message>
        <source>there is no material</source>
        <translation>es gibt kein Material</translation>
    </message>
    <message>
        <source>no other body is open; choose a file</source>
        <translation>kein anderer Körper ist geöffnet; wählen Sie eine Datei</translation>
    </message>
    <message>
        <source>it is being computed</source>
        <translation>es wird berechnet</translation>
    </message>
    <message>
        <source>Combine volumes</source>
        <translation>Volumen kombinieren</translation>
    </message>
    <message>
        <source>Close gaps</source>
        <translation>Lücken schließen</translation>
    </message>
    <message>
        <source>Smooth volume</source>
        <translation>Volumen glätten</translation>
    </message>
    <message>
        <source>Make shell</source>
        <translation>Schale erzeugen</translation>
    </message>
    <message>
        <source>Move surface</source>
        <translation>Oberfläche versetzen</translation>
    </message>
    <message>
        <source>all neighbours agree already</source>
        <translation>alle Nachbarn stimmen schon überein</translation>
    </message>
    <message>
        <source>it would take too long for a mesh of this size; “handwheel voxelize --wall” makes a volume with walls of any sheets</source>
        <translation>das würde für ein Netz dieser Größe zu lange dauern; „handwheel voxelize --wall“ erzeugt ein Volumen mit Wänden aus beliebigen offenen Flächen</translation>
    </message>
    <message>
        <source>Orient consistently</source>
        <translation>Einheitlich orientieren</translation>
    </message>
    <message>
        <source>no part is that small</source>
        <translation>kein Teil ist so klein</translation>
    </message>
    <message>
        <source>the surface encloses nothing, even with its holes closed: set a wall thickness to make walls of it</source>
        <translation>die Oberfläche umschließt auch mit geschlossenen Löchern nichts: geben Sie eine Wandstärke an, um daraus Wände zu machen</translation>
    </message>
    <message>
        <source>Unmask clay</source>
        <translation>Maske von Ton entfernen</translation>
    </message>
    <message>
        <source>Mask clay</source>
        <translation>Ton maskieren</translation>
    </message>
    <message>
        <source>mask clay</source>
        <translation>Ton maskieren</translation>
    </message>
    <message>
        <source>invert the mask</source>
        <translation>Maske umkehren</translation>
    </message>
    <message>
        <source>clear the mask</source>
        <translation>Maske löschen</translation>
    </message>
    <message>
        <source>load a stamp</source>
        <translation>Stempel laden</translation>
    </message>
    <message>
        <source>Invert the mask</source>
        <translation>Maske umkehren</translation>
    </message>
    <message>
        <source>Clear the mask</source>
        <translation>Maske löschen</translation>
    </message>
    <message>
        <source>nothing is masked</source>
        <translation>nichts ist maskiert</translation>
    </message>
    <message>
        <source>the drill would cut sideways here: begin on a free surface</source>
        <translation>der Bohrer würde hier seitlich schneiden: beginnen Sie an einer freien Oberfläche</translation>
    </message>
    <message>
        <source>Unite bodies</source>
        <translation>Körper vereinigen</translation>
    </message>
    <message>
        <source>only closed bodies can be united: close holes and open sheets, and reverse bodies that are inside out before</source>
        <translation>nur geschlossene Körper können vereinigt werden: schließen Sie vorher Löcher und offene Flächen, und wenden Sie umgestülpte Körper</translation>
    </message>
    <message>
        <source>pull a place of a path</source>
        <translation>Punkt einer Bahn ziehen</translation>
    </message>
    <message>
        <source>Smudge clay</source>
        <translation>Ton verwischen</translation>
    </message>
    <message>
        <source>hold the feed</source>
        <translation>Vorschub anhalten</translation>
    </message>
    <message>
        <source>the feed is held</source>
        <translation>der Vorschub ist angehalten</translation>
    </message>
    <message>
        <source>go on with the feed</source>
        <translation>Vorschub fortsetzen</translation>
    </message>
    <message>
        <source>Measuring the mesh</source>
        <translation>Das Netz wird vermessen</translation>
    </message>
    <message>
        <source>the mesh is being measured</source>
        <translation>das Netz wird vermessen</translation>
    </message>
    <message>
        <source>Shape clay</source>
        <translation>Ton formen</translation>
    </message>
    <message>
        <source>select a body, robot or frame</source>
        <translation>wählen Sie einen Körper, einen Roboter oder ein Koordinatensystem</translation>
    </message>
    <message>
        <source>the top layer is off, or weaker than 1</source>
        <translation>die oberste Ebene ist aus oder schwächer als 1</translation>
    </message>
    <message>
        <source>the mesh is not closed, or not manifold</source>
        <translation>das Netz ist nicht geschlossen oder nicht mannigfaltig</translation>
    </message>
    <message>
        <source>triangles of the mesh intersect one another</source>
        <translation>Dreiecke des Netzes schneiden sich</translation>
    </message>
    <message>
        <source>the hole meets too many triangles</source>
        <translation>das Loch trifft auf zu viele Dreiecke</translation>
    </message>
    <message>
        <source>the triangles cannot be joined soundly along the hole</source>
        <translation>die Dreiecke lassen sich am Loch nicht einwandfrei verbinden</translation>
    </message>
    <message>
        <source>nothing would be left of the mesh</source>
        <translation>vom Netz bliebe nichts übrig</translation>
    </message>
    <message>
        <source>Drill a hole</source>
        <translation>Loch bohren</translation>
    </message>
    <message>
        <source>the mesh was changed meanwhile</source>
        <translation>das Netz wurde inzwischen geändert</translation>
    </message>
    <message>
        <source>there are no triangles</source>
        <translation>es gibt keine Dreiecke</translation>
    </message>
    <message>
        <source>the mesh has holes, so it has no inside: close them first</source>
        <translation>das Netz hat Löcher und damit kein Inneres: zuerst schließen</translation>
    </message>
    <message>
        <source>the mesh is not manifold: repair it first</source>
        <translation>das Netz ist nicht mannigfaltig: zuerst reparieren</translation>
    </message>
    <message>
        <source>a body is inside out: turn it over first</source>
        <translation>ein Körper ist umgestülpt: zuerst wenden</translation>
    </message>
    <message>
        <source>the voxels are too small for a part of this size</source>
        <translation>die Voxel sind zu klein für ein Teil dieser Größe</translation>
    </message>
    <message>
        <source>the surface encloses nothing</source>
        <translation>die Oberfläche umschließt nichts</translation>
    </message>
    <message>
        <source>there are coordinates that are not numbers</source>
        <translation>es gibt Koordinaten, die keine Zahlen sind</translation>
    </message>
    <message>
        <source>bodies overlap here, or a wall is thinner than a voxel: near the drill alone this cannot be drilled</source>
        <translation>hier überlappen sich Körper, oder eine Wand ist dünner als ein Voxel: nur nahe am Bohrer kann das nicht gebohrt werden</translation>
    </message>
    <message>
        <source>triangles of the mesh intersect one another: resolve that first</source>
        <translation>Dreiecke des Netzes schneiden sich: zuerst beheben</translation>
    </message>
    <message>
        <source>Preparing to drill</source>
        <translation>Bohren wird vorbereitet</translation>
    </message>
    <message>
        <source>the hole is being taken from the triangles</source>
        <translation>das Loch wird aus den Dreiecken geschnitten</translation>
    </message>
    <message>
        <source>the mesh is being prepared for the drill</source>
        <translation>das Netz wird für den Bohrer vorbereitet</translation>
    </message>
    <message>
        <source>Pass %1</source>
        <translation>Schnitt %1</translation>
    </message>
    <message>
        <source>Plunging pass %1</source>
        <translation>Einstechschnitt %1</translation>
    </message>
    <message>
        <source>Threading pass %1</source>
        <translation>Gewindeschnitt %1</translation>
    </message>
    <message>
        <source>Boring pass %1</source>
        <translation>Innendrehschnitt %1</translation>
    </message>
    <message>
        <source>Drilling pass %1</source>
        <translation>Bohrgang %1</translation>
    </message>
    <message>
        <source>Filing pass %1</source>
        <translation>Feilgang %1</translation>
    </message>
    <message>
        <source>Grinding pass %1</source>
        <translation>Schleifgang %1</translation>
    </message>
    <message>
        <source>%1: −%2 mm³</source>
        <translation>%1: −%2 mm³</translation>
    </message>
    <message>
        <source>this volume is to be drilled, not shaped</source>
        <translation>dieses Volumen ist zu bohren, nicht zu formen</translation>
    </message>
    <message>
        <source>no two vertices can be merged so that an open edge closes and none gets a third triangle</source>
        <translation>keine zwei Eckpunkte lassen sich so zusammenführen, dass sich eine offene Kante schließt und keine ein drittes Dreieck bekommt</translation>
    </message>
    <message>
        <source>Refining</source>
        <translation>Wird verfeinert</translation>
    </message>
</context>
<context>
    <name>ToolInput</name>
    <message>
        <source>Click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Umschalt+Klick</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Strg+Klick</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Strg+Ziehen</translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Loslassen</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Shift+hold</source>
        <translation>Umschalt+Halten</translation>
    </message>
</context>
<context>
    <name>ToolReadout</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 – limit (%2)</source>
        <translation>%1 – Grenze (%2)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>WindowServices</name>
    <message>
        <source>Autosave</source>
        <translation>Automatisches Sichern</translation>
    </message>
    <message>
        <source>Search for self-intersections</source>
        <translation>Suche nach Selbstdurchdringungen</translation>
    </message>
    <message>
        <source>Preview of the patch</source>
        <translation>Vorschau der Füllfläche</translation>
    </message>
    <message>
        <source>Servo loop of the device</source>
        <translation>Servoschleife des Geräts</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
</context>
<context>
    <name>handwheel::Autosave</name>
    <message>
        <source>Autosaving %1</source>
        <translation>%1 wird automatisch gesichert</translation>
    </message>
    <message numerus="yes">
        <source>Handwheel ended unexpectedly. %Ln document(s) had changes that were not saved.</source>
        <translation>
            <numerusform>Handwheel wurde unerwartet beendet. %Ln Dokument hatte nicht gespeicherte Änderungen.</numerusform>
            <numerusform>Handwheel wurde unerwartet beendet. %Ln Dokumente hatten nicht gespeicherte Änderungen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>%1 (its file was saved since)</source>
        <translation>%1 (die Datei wurde seither gespeichert)</translation>
    </message>
    <message>
        <source>%1 could not be autosaved</source>
        <translation>%1 konnte nicht automatisch gesichert werden</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message numerus="yes">
        <source>%Ln autosave(s) of a session that ended unexpectedly cannot be read.</source>
        <translation>
            <numerusform>%Ln automatische Sicherung einer unerwartet beendeten Sitzung lässt sich nicht lesen.</numerusform>
            <numerusform>%Ln automatische Sicherungen einer unerwartet beendeten Sitzung lassen sich nicht lesen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Discarded %Ln autosave(s)</source>
        <translation>
            <numerusform>%Ln automatische Sicherung verworfen</numerusform>
            <numerusform>%Ln automatische Sicherungen verworfen</numerusform>
        </translation>
    </message>
    <message>
        <source>Discard…</source>
        <translation>Verwerfen…</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Save it now: if the program ended unexpectedly, your last changes would be lost.</source>
        <translation>Speichern Sie es jetzt: Bei einem unerwarteten Programmende gingen Ihre letzten Änderungen verloren.</translation>
    </message>
    <message>
        <source>They can be recovered as they were last autosaved, or discarded permanently; otherwise they are offered again at the next start.</source>
        <translation>Sie lassen sich im zuletzt gesicherten Stand wiederherstellen oder endgültig verwerfen; sonst werden sie beim nächsten Start wieder angeboten.</translation>
    </message>
    <message numerus="yes">
        <source>Discard %Ln document(s) permanently?</source>
        <translation>
            <numerusform>%Ln Dokument endgültig verwerfen?</numerusform>
            <numerusform>%Ln Dokumente endgültig verwerfen?</numerusform>
        </translation>
    </message>
    <message>
        <source>Their changes since they were last saved cannot be recovered.</source>
        <translation>Ihre Änderungen seit dem letzten Speichern sind dann nicht wiederzubringen.</translation>
    </message>
    <message>
        <source>Their contents are lost. They are kept until you discard them.</source>
        <translation>Ihr Inhalt ist verloren. Sie bleiben, bis Sie sie verwerfen.</translation>
    </message>
    <message>
        <source>The files are listed in the Log.</source>
        <translation>Die Dateien sind im Protokoll aufgeführt.</translation>
    </message>
</context>
<context>
    <name>handwheel::AxisBars</name>
    <message>
        <source>Position and orientation</source>
        <translation>Lage und Ausrichtung</translation>
    </message>
    <message>
        <source>Grip</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>Drag a knob to move the simulated hand; with keys: arrows, finer with Ctrl, Page Up and Down, Home</source>
        <translation>Knopf ziehen, um die simulierte Hand zu bewegen; mit Tasten: Pfeile, feiner mit Strg, Bild auf und ab, Pos1</translation>
    </message>
</context>
<context>
    <name>handwheel::BenchmarkRunner</name>
    <message>
        <source>the file is damaged.</source>
        <translation>Die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>The measurements of this machine cannot be used: %1</source>
        <translation>Die Messwerte dieses Rechners sind nicht verwendbar: %1</translation>
    </message>
    <message>
        <source>The stored measurements are from another machine (%1).</source>
        <translation>Die gespeicherten Messwerte stammen von einem anderen Rechner (%1).</translation>
    </message>
    <message>
        <source>The measurements could not be saved: %1</source>
        <translation>Die Messwerte konnten nicht gespeichert werden: %1</translation>
    </message>
</context>
<context>
    <name>handwheel::BodyList</name>
    <message>
        <source>Bodies</source>
        <translation>Körper</translation>
    </message>
</context>
<context>
    <name>handwheel::BodyModel</name>
    <message>
        <source>%1, hidden</source>
        <translation>%1, ausgeblendet</translation>
    </message>
    <message>
        <source>Linked to %1, which is missing</source>
        <translation>Verknüpft mit %1, die fehlt</translation>
    </message>
    <message>
        <source>Linked to %1, which has changed since it was read</source>
        <translation>Verknüpft mit %1, die sich seit dem Einlesen geändert hat</translation>
    </message>
    <message>
        <source>Linked to %1</source>
        <translation>Verknüpft mit %1</translation>
    </message>
    <message>
        <source>Hide the body</source>
        <translation>Den Körper ausblenden</translation>
    </message>
    <message>
        <source>Show the body</source>
        <translation>Den Körper zeigen</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Ausgeblendet</translation>
    </message>
    <message>
        <source>Drop bodies here for %1 to carry them</source>
        <translation>Körper hier ablegen, damit %1 sie trägt</translation>
    </message>
</context>
<context>
    <name>handwheel::ButtonLamps</name>
    <message>
        <source>Buttons</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>No button is held</source>
        <translation>Keine Taste wird gehalten</translation>
    </message>
    <message>
        <source>Held: %1</source>
        <translation>Gehalten: %1</translation>
    </message>
    <message>
        <source>Click to hold a button of the simulated hand, and again to release it; or press its number</source>
        <translation>Klicken, um eine Taste der simulierten Hand zu halten, und noch einmal, um sie loszulassen; oder ihre Nummer drücken</translation>
    </message>
</context>
<context>
    <name>handwheel::CalibrationRow</name>
    <message>
        <source>Measuring this machine</source>
        <translation>Dieser Rechner wird gemessen</translation>
    </message>
    <message>
        <source>Measuring this machine: %1</source>
        <translation>Dieser Rechner wird gemessen: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Measure this machine</source>
        <translation>Diesen Rechner messen</translation>
    </message>
    <message>
        <source>Takes about half a minute. You can go on working.</source>
        <translation>Dauert etwa eine halbe Minute. Sie können weiterarbeiten.</translation>
    </message>
    <message>
        <source>The curves were supplied with the program: %1, %2.</source>
        <translation>Die Kurven kamen mit dem Programm: %1, %2.</translation>
    </message>
    <message>
        <source>The curves were measured on this machine, %1.</source>
        <translation>Die Kurven sind von diesem Rechner, %1.</translation>
    </message>
    <message>
        <source>%1 of %2 curves were measured on this machine.</source>
        <translation>%1 von %2 Kurven sind von diesem Rechner.</translation>
    </message>
</context>
<context>
    <name>handwheel::CellBodies</name>
    <message>
        <source>Add a body</source>
        <translation>Körper hinzufügen</translation>
    </message>
    <message>
        <source>Add a &amp;shape</source>
        <translation>&amp;Form hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Add a body from a file…</source>
        <translation>&amp;Körper aus einer Datei hinzufügen…</translation>
    </message>
    <message>
        <source>Add a body &amp;linked to a file…</source>
        <translation>Mit einer Datei &amp;verknüpften Körper hinzufügen…</translation>
    </message>
    <message>
        <source>&amp;Remove the body</source>
        <translation>Körper &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Hide the body</source>
        <translation>Körper &amp;ausblenden</translation>
    </message>
    <message>
        <source>Show all &amp;bodies</source>
        <translation>Alle Kör&amp;per zeigen</translation>
    </message>
    <message>
        <source>Read the linked file a&amp;gain</source>
        <translation>Verknüpfte Datei &amp;neu einlesen</translation>
    </message>
    <message>
        <source>Show all bodies that are hidden</source>
        <translation>Alle ausgeblendeten Körper zeigen</translation>
    </message>
    <message>
        <source>Add a linked body</source>
        <translation>Verknüpften Körper hinzufügen</translation>
    </message>
    <message>
        <source>Nothing has changed</source>
        <translation>Es hat sich nichts geändert</translation>
    </message>
    <message>
        <source>Link to an&amp;other file…</source>
        <translation>Mit &amp;anderer Datei verknüpfen…</translation>
    </message>
    <message>
        <source>Remove the selected bodies from the cell</source>
        <translation>Die ausgewählten Körper aus der Zelle entfernen</translation>
    </message>
    <message>
        <source>Open a robot cell first.</source>
        <translation>Öffnen Sie zuerst eine Roboterzelle.</translation>
    </message>
    <message>
        <source>Select a body first, in the view or in the list.</source>
        <translation>Wählen Sie zuerst einen Körper aus, in der Ansicht oder in der Liste.</translation>
    </message>
    <message>
        <source>It is hidden.</source>
        <translation>Er ist ausgeblendet.</translation>
    </message>
    <message>
        <source>No body is hidden.</source>
        <translation>Kein Körper ist ausgeblendet.</translation>
    </message>
    <message>
        <source>Select one body only.</source>
        <translation>Wählen Sie nur einen Körper aus.</translation>
    </message>
    <message>
        <source>The body is not linked to a file.</source>
        <translation>Der Körper ist mit keiner Datei verknüpft.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Link %1 to another file</source>
        <translation>%1 mit anderer Datei verknüpfen</translation>
    </message>
    <message>
        <source>Read the file of %1 again</source>
        <translation>Die Datei von %1 neu einlesen</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>Show the bodies</source>
        <translation>Die Körper zeigen</translation>
    </message>
    <message>
        <source>Hide the bodies</source>
        <translation>Die Körper ausblenden</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Unlink the &amp;file</source>
        <translation>Verknüpfung mit der &amp;Datei lösen</translation>
    </message>
    <message>
        <source>Add the shape of another file beside the robot</source>
        <translation>Die Form einer anderen Datei neben dem Roboter hinzufügen</translation>
    </message>
    <message>
        <source>Add the shape of another file and link to the file, to read it again when it has changed</source>
        <translation>Die Form einer anderen Datei hinzufügen und mit der Datei verknüpfen, um sie nach Änderungen neu einzulesen</translation>
    </message>
    <message>
        <source>Hide the selected bodies from view and touch</source>
        <translation>Die ausgewählten Körper weder anzeigen noch fühlbar machen</translation>
    </message>
    <message>
        <source>Read the file that the selected body is linked to again</source>
        <translation>Die Datei, mit der der ausgewählte Körper verknüpft ist, noch einmal einlesen</translation>
    </message>
    <message>
        <source>Use the shape of another file; name, position and colour are kept</source>
        <translation>Die Form einer anderen Datei verwenden; Name, Position und Farbe bleiben</translation>
    </message>
    <message>
        <source>Keep the selected body as it is, without a link to its file</source>
        <translation>Den ausgewählten Körper ohne Verknüpfung mit seiner Datei behalten</translation>
    </message>
    <message>
        <source>Add a body of this shape beside the robot</source>
        <translation>Einen Körper dieser Form neben dem Roboter hinzufügen</translation>
    </message>
    <message>
        <source>Unlink the file of %1</source>
        <translation>Verknüpfung von %1 mit der Datei lösen</translation>
    </message>
    <message>
        <source>&amp;Mount the body on the tool flange</source>
        <translation>Den Körper am Werkzeugflansch &amp;befestigen</translation>
    </message>
    <message>
        <source>Take the body off the &amp;robot</source>
        <translation>Den Körper vom Robote&amp;r nehmen</translation>
    </message>
    <message>
        <source>The robot does not carry it.</source>
        <translation>Der Roboter trägt ihn nicht.</translation>
    </message>
    <message>
        <source>Mount %1 on %2</source>
        <translation>%1 an %2 befestigen</translation>
    </message>
    <message>
        <source>Release %1</source>
        <translation>%1 loslassen</translation>
    </message>
    <message>
        <source>Re&amp;name the body</source>
        <translation>Körper &amp;umbenennen</translation>
    </message>
    <message>
        <source>Choose the &amp;unit of its numbers…</source>
        <translation>Einheit seiner &amp;Zahlen wählen…</translation>
    </message>
    <message>
        <source>Give the selected body another name, in the list</source>
        <translation>Dem ausgewählten Körper in der Liste einen anderen Namen geben</translation>
    </message>
    <message>
        <source>Unlink the file first: it is read again with its own numbers.</source>
        <translation>Lösen Sie zuerst die Verknüpfung mit der Datei: Sie wird mit ihren eigenen Zahlen neu eingelesen.</translation>
    </message>
    <message>
        <source>Only bodies from mesh files have numbers without a unit.</source>
        <translation>Nur Körper aus Netzdateien haben Zahlen ohne Einheit.</translation>
    </message>
    <message>
        <source>%1: the body measures %2</source>
        <translation>%1: Der Körper misst %2</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>Einheit von %1</translation>
    </message>
    <message>
        <source>Its numbers are in:</source>
        <translation>Seine Zahlen sind in:</translation>
    </message>
    <message>
        <source>Scaling %1</source>
        <translation>%1 wird skaliert</translation>
    </message>
    <message>
        <source>Change the unit of %1</source>
        <translation>Einheit von %1 ändern</translation>
    </message>
    <message>
        <source>%1 measures %2</source>
        <translation>%1 misst %2</translation>
    </message>
    <message>
        <source>%1 has no unit; its numbers were taken as millimetres.</source>
        <translation>%1 hat keine Einheit; die Zahlen wurden als Millimeter genommen.</translation>
    </message>
    <message>
        <source>Choose the unit…</source>
        <translation>Einheit wählen…</translation>
    </message>
    <message>
        <source>Specify the unit of the numbers of its file: STL, OBJ, PLY and OFF have none and are taken as mm</source>
        <translation>Die Einheit der Zahlen seiner Datei angeben: STL, OBJ, PLY und OFF haben keine und gelten als mm</translation>
    </message>
    <message>
        <source>Attach the selected body to the robot as a tool, with its origin at the flange</source>
        <translation>Den ausgewählten Körper als Werkzeug am Roboter befestigen, mit seinem Ursprung am Flansch</translation>
    </message>
    <message>
        <source>Detach the selected body from the robot and leave it where it is</source>
        <translation>Den ausgewählten Körper vom Roboter lösen und dort lassen, wo er ist</translation>
    </message>
    <message>
        <source>The bodies were not changed</source>
        <translation>Die Körper wurden nicht geändert</translation>
    </message>
    <message numerus="yes">
        <source>%n body(ies)</source>
        <translation>
            <numerusform>%n Körper</numerusform>
            <numerusform>%n Körper</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing carries %1, as before</source>
        <translation>Nichts trägt %1, wie zuvor</translation>
    </message>
    <message>
        <source>Only links of robots carry bodies; a body carries none.</source>
        <translation>Nur Glieder von Robotern tragen Körper; ein Körper trägt keinen.</translation>
    </message>
    <message>
        <source>Drop it on a link, or on a body that a link carries.</source>
        <translation>Legen Sie ihn auf einem Glied ab oder auf einem Körper, den ein Glied trägt.</translation>
    </message>
    <message>
        <source>Attach %1 to %2</source>
        <translation>%1 an %2 anbringen</translation>
    </message>
    <message>
        <source>&amp;Place it beside the others</source>
        <translation>Neben die anderen &amp;stellen</translation>
    </message>
    <message>
        <source>Tool &amp;centre point at its tip</source>
        <translation>Werkzeug&amp;mittelpunkt an seine Spitze</translation>
    </message>
    <message>
        <source>Put the selected body in front of the robot and of all other bodies, on the floor</source>
        <translation>Den gewählten Körper vor den Roboter und alle anderen Körper auf den Boden stellen</translation>
    </message>
    <message>
        <source>Put the tool centre point in the middle of what reaches farthest along the Z axis of the flange</source>
        <translation>Den Werkzeugmittelpunkt in die Mitte dessen setzen, was entlang der Z-Achse des Flansches am weitesten reicht</translation>
    </message>
    <message>
        <source>A link of the robot carries it.</source>
        <translation>Ein Glied des Roboters trägt ihn.</translation>
    </message>
    <message>
        <source>The flange does not carry it.</source>
        <translation>Der Flansch trägt ihn nicht.</translation>
    </message>
    <message>
        <source>Place %1 beside the others</source>
        <translation>%1 neben die anderen stellen</translation>
    </message>
    <message>
        <source>%1 was mounted on %2</source>
        <translation>%1 wurde an %2 montiert</translation>
    </message>
    <message>
        <source>The tool centre point is where it was; it is a group of fields in the panel.</source>
        <translation>Der Werkzeugmittelpunkt ist, wo er war; er ist eine Gruppe von Feldern im Feld.</translation>
    </message>
    <message>
        <source>Tool centre point at the tip of %1</source>
        <translation>Werkzeugmittelpunkt an der Spitze von %1</translation>
    </message>
    <message>
        <source>Place %1 where its file says</source>
        <translation>%1 dorthin setzen, wo die Datei sagt</translation>
    </message>
    <message>
        <source>%1 was placed beside the others</source>
        <translation>%1 wurde neben die anderen gestellt</translation>
    </message>
    <message>
        <source>Where its file says, it would be inside something else: it was placed beside the others.</source>
        <translation>An der Stelle aus der Datei läge es in etwas anderem: Es wurde neben die anderen gestellt.</translation>
    </message>
    <message>
        <source>&amp;Place it where its file says</source>
        <translation>&amp;Dorthin setzen, wo die Datei sagt</translation>
    </message>
</context>
<context>
    <name>handwheel::CellCollisions</name>
    <message>
        <source>Preparing the cell for collisions</source>
        <translation>Zelle wird für Kollisionen vorbereitet</translation>
    </message>
</context>
<context>
    <name>handwheel::CellContactMarks</name>
    <message>
        <source>Show where things to&amp;uch</source>
        <translation>Zeigen, wo sich Dinge &amp;berühren</translation>
    </message>
    <message>
        <source>Mark the places where links and bodies collide, with the way out of each other</source>
        <translation>Die Stellen markieren, an denen Glieder und Körper kollidieren, mit der Richtung auseinander</translation>
    </message>
</context>
<context>
    <name>handwheel::CellPaths</name>
    <message>
        <source>&amp;Store this configuration</source>
        <translation>Diese &amp;Stellung speichern</translation>
    </message>
    <message>
        <source>&amp;Go to it</source>
        <translation>&amp;Hinfahren</translation>
    </message>
    <message>
        <source>&amp;Plan a path…</source>
        <translation>Bahn &amp;planen…</translation>
    </message>
    <message>
        <source>Plan the path &amp;again</source>
        <translation>Bahn &amp;neu planen</translation>
    </message>
    <message>
        <source>&amp;Insert this configuration into the path</source>
        <translation>Diese Stellung in die Bahn e&amp;infügen</translation>
    </message>
    <message>
        <source>Set the place to &amp;here</source>
        <translation>Punkt &amp;hierher setzen</translation>
    </message>
    <message>
        <source>Move the place &amp;up</source>
        <translation>Punkt nach &amp;oben</translation>
    </message>
    <message>
        <source>Move the place &amp;down</source>
        <translation>Punkt nach &amp;unten</translation>
    </message>
    <message>
        <source>Straight &amp;line to the place</source>
        <translation>Gerade &amp;Linie zum Punkt</translation>
    </message>
    <message>
        <source>&amp;Verify the path</source>
        <translation>Bahn prü&amp;fen</translation>
    </message>
    <message>
        <source>&amp;Export a robot program…</source>
        <translation>Roboterprogramm &amp;exportieren…</translation>
    </message>
    <message>
        <source>Open a robot program as a pa&amp;th…</source>
        <translation>Roboterprogramm als &amp;Bahn öffnen…</translation>
    </message>
    <message>
        <source>Read allowed pairs (S&amp;RDF)…</source>
        <translation>Erlaubte Paare lesen (SR&amp;DF)…</translation>
    </message>
    <message>
        <source>Plan a path between configurations that is proven free of collisions</source>
        <translation>Plant eine Bahn zwischen Stellungen, die bewiesen kollisionsfrei ist</translation>
    </message>
    <message>
        <source>Move the tool&apos;s centre point to the place along a straight line</source>
        <translation>Bewegt den Werkzeugmittelpunkt auf einer geraden Linie zum Punkt</translation>
    </message>
    <message>
        <source>Write the path for a controller (RAPID, KRL, Fanuc, URScript, CSV, JSON), if it is free of collisions</source>
        <translation>Schreibt die Bahn für eine Steuerung (RAPID, KRL, Fanuc, URScript, CSV, JSON), wenn sie kollisionsfrei ist</translation>
    </message>
    <message>
        <source>Read a program of a controller as a path of this cell</source>
        <translation>Liest das Programm einer Steuerung als Bahn dieser Zelle</translation>
    </message>
    <message>
        <source>Open a robot program</source>
        <translation>Roboterprogramm öffnen</translation>
    </message>
    <message>
        <source>Robot programs (*.mod *.src *.ls *.script *.csv *.json);;All files (*)</source>
        <translation>Roboterprogramme (*.mod *.src *.ls *.script *.csv *.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Read allowed pairs</source>
        <translation>Erlaubte Paare lesen</translation>
    </message>
    <message>
        <source>Semantic descriptions (*.srdf *.xml);;All files (*)</source>
        <translation>Semantische Beschreibungen (*.srdf *.xml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a robot cell first.</source>
        <translation>Öffnen Sie zuerst eine Roboterzelle.</translation>
    </message>
    <message>
        <source>Select a place of a path first.</source>
        <translation>Wählen Sie zuerst einen Punkt einer Bahn.</translation>
    </message>
    <message>
        <source>Select a path first.</source>
        <translation>Wählen Sie zuerst eine Bahn.</translation>
    </message>
    <message>
        <source>Only a path that is proven free of collisions is exported.</source>
        <translation>Nur eine Bahn, die bewiesen kollisionsfrei ist, wird exportiert.</translation>
    </message>
    <message>
        <source>This could not be done</source>
        <translation>Das war nicht möglich</translation>
    </message>
    <message>
        <source>Configuration %1</source>
        <translation>Stellung %1</translation>
    </message>
    <message>
        <source>Store %1</source>
        <translation>%1 speichern</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>Nach %1 fahren</translation>
    </message>
    <message>
        <source>Go to place %1 of %2</source>
        <translation>Zu Punkt %1 von %2 fahren</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Plan %1</source>
        <translation>%1 planen</translation>
    </message>
    <message>
        <source>Plan %1 again</source>
        <translation>%1 neu planen</translation>
    </message>
    <message>
        <source>The cell is still being prepared</source>
        <translation>Die Zelle wird noch vorbereitet</translation>
    </message>
    <message>
        <source>Planning %1</source>
        <translation>%1 wird geplant</translation>
    </message>
    <message>
        <source>Insert a place into %1</source>
        <translation>Punkt in %1 einfügen</translation>
    </message>
    <message>
        <source>Set place %1 of %2</source>
        <translation>Punkt %1 von %2 setzen</translation>
    </message>
    <message>
        <source>Move place %1 of %2</source>
        <translation>Punkt %1 von %2 verschieben</translation>
    </message>
    <message>
        <source>Straight line to place %1</source>
        <translation>Gerade Linie zu Punkt %1</translation>
    </message>
    <message>
        <source>Joint motion to place %1</source>
        <translation>Gelenkbewegung zu Punkt %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Remove place %1 of %2</source>
        <translation>Punkt %1 von %2 entfernen</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Export a robot program</source>
        <translation>Roboterprogramm exportieren</translation>
    </message>
    <message numerus="yes">
        <source>%Ln motion(s), read back within %1 mm.</source>
        <translation>
            <numerusform>%Ln Bewegung, zurückgelesen auf %1 mm genau.</numerusform>
            <numerusform>%Ln Bewegungen, zurückgelesen auf %1 mm genau.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was written</source>
        <translation>%1 wurde geschrieben</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Bearbeitung</translation>
    </message>
    <message>
        <source>Optimising %1</source>
        <translation>%1 wird optimiert</translation>
    </message>
    <message>
        <source>Optimise %1</source>
        <translation>%1 optimieren</translation>
    </message>
    <message>
        <source>Cycle time %1 s before, %2 s now.</source>
        <translation>Taktzeit vorher %1 s, jetzt %2 s.</translation>
    </message>
    <message>
        <source>The places are in another order.</source>
        <translation>Die Punkte haben eine andere Reihenfolge.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln place(s) in another configuration of the arm.</source>
        <translation>
            <numerusform>%Ln Punkt in einer anderen Stellung des Arms.</numerusform>
            <numerusform>%Ln Punkte in einer anderen Stellung des Arms.</numerusform>
        </translation>
    </message>
    <message>
        <source>No other order or configuration takes less than its %1 s.</source>
        <translation>Keine andere Reihenfolge oder Stellung braucht weniger als die jetzigen %1 s.</translation>
    </message>
    <message>
        <source>%1 was optimised</source>
        <translation>%1 wurde optimiert</translation>
    </message>
    <message>
        <source>Store a &amp;target here</source>
        <translation>&amp;Ziel hier speichern</translation>
    </message>
    <message>
        <source>Optimise the order and &amp;configurations</source>
        <translation>Reihenfolge und Stellungen op&amp;timieren</translation>
    </message>
    <message>
        <source>Move the robot to the selected configuration, place or target</source>
        <translation>Bewegt den Roboter zur gewählten Stellung, zum gewählten Punkt oder Ziel</translation>
    </message>
    <message>
        <source>Store a configuration or a target first: where the path is to begin or end.</source>
        <translation>Speichern Sie zuerst eine Stellung oder ein Ziel: wo die Bahn beginnen oder enden soll.</translation>
    </message>
    <message>
        <source>Select a configuration, a place or a target first.</source>
        <translation>Wählen Sie zuerst eine Stellung, einen Punkt oder ein Ziel.</translation>
    </message>
    <message>
        <source>There is nothing between the ends of the path.</source>
        <translation>Zwischen den Enden der Bahn liegt nichts.</translation>
    </message>
    <message>
        <source>Try again in a moment.</source>
        <translation>Versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>Target %1</source>
        <translation>Ziel %1</translation>
    </message>
    <message>
        <source>Store %1 on %2</source>
        <translation>%1 auf %2 speichern</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>%1 setzen</translation>
    </message>
    <message>
        <source>Begin a path</source>
        <translation>Bahn beginnen</translation>
    </message>
    <message>
        <source>%1 is not the language of the controller of this robot, %2.</source>
        <translation>%1 ist nicht die Sprache der Steuerung dieses Roboters, %2.</translation>
    </message>
    <message>
        <source>%1 was changed while it was planned</source>
        <translation>%1 wurde geändert, während die Planung lief</translation>
    </message>
    <message>
        <source>The cell was changed while %1 was planned</source>
        <translation>Die Zelle wurde geändert, während %1 geplant wurde</translation>
    </message>
    <message>
        <source>Plan it again</source>
        <translation>Neu planen</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Plan for this ro&amp;bot</source>
        <translation>F&amp;ür diesen Roboter planen</translation>
    </message>
    <message>
        <source>Plan the path again through its critical places; one along a curve follows it where the part is now</source>
        <translation>Plant die Bahn noch einmal durch ihre kritischen Punkte; eine Bahn entlang einer Kurve folgt dieser dort, wo das Teil jetzt ist</translation>
    </message>
    <message>
        <source>Select a robot in the list first, in a cell with several.</source>
        <translation>Wählen Sie zuerst einen Roboter in der Liste, in einer Zelle mit mehreren.</translation>
    </message>
    <message>
        <source>%1 was verified: %2</source>
        <translation>%1 wurde geprüft: %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln motion(s)</source>
        <translation>
            <numerusform>%Ln Bewegung</numerusform>
            <numerusform>%Ln Bewegungen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 could not be planned</source>
        <translation>%1 konnte nicht geplant werden</translation>
    </message>
    <message>
        <source>Change the process of %1</source>
        <translation>Bearbeitung von %1 ändern</translation>
    </message>
    <message>
        <source>Save in:</source>
        <translation>Speichern in:</translation>
    </message>
    <message>
        <source>%1 is there already</source>
        <translation>%1 ist schon vorhanden</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Verif&amp;y all paths</source>
        <translation>&amp;Alle Bahnen prüfen</translation>
    </message>
    <message>
        <source>The cell has no path yet.</source>
        <translation>Die Zelle hat noch keine Bahn.</translation>
    </message>
    <message>
        <source>Read %1 for %2</source>
        <translation>%1 für %2 lesen</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of links that may touch</source>
        <translation>
            <numerusform>%Ln Paar von Gliedern, die sich berühren dürfen</numerusform>
            <numerusform>%Ln Paare von Gliedern, die sich berühren dürfen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln named state(s).</source>
        <translation>
            <numerusform>%Ln benannte Stellung.</numerusform>
            <numerusform>%Ln benannte Stellungen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln entry(ies) name links or joints that the robot does not have, and were left out; see the log.</source>
        <translation>
            <numerusform>%Ln Eintrag nennt Glieder oder Gelenke, die der Roboter nicht hat, und wurde ausgelassen; siehe Protokoll.</numerusform>
            <numerusform>%Ln Einträge nennen Glieder oder Gelenke, die der Roboter nicht hat, und wurden ausgelassen; siehe Protokoll.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was read for %2</source>
        <translation>%1 wurde für %2 gelesen</translation>
    </message>
    <message>
        <source>%1 was planned</source>
        <translation>%1 wurde geplant</translation>
    </message>
    <message numerus="yes">
        <source>It has %Ln place(s), and is selected in the list.</source>
        <translation>
            <numerusform>Sie hat %Ln Punkt und ist in der Liste ausgewählt.</numerusform>
            <numerusform>Sie hat %Ln Punkte und ist in der Liste ausgewählt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>U&amp;mbenennen</translation>
    </message>
    <message>
        <source>Remo&amp;ve from the plan</source>
        <translation>Aus dem Plan entfe&amp;rnen</translation>
    </message>
    <message>
        <source>%1 was stored</source>
        <translation>%1 wurde gespeichert</translation>
    </message>
    <message>
        <source>It is selected in the list.</source>
        <translation>In der Liste ist der Eintrag ausgewählt.</translation>
    </message>
    <message>
        <source>It moves with %1.</source>
        <translation>Es bewegt sich mit %1.</translation>
    </message>
    <message>
        <source>Place %1 of %2 was stored</source>
        <translation>Punkt %1 von %2 wurde gespeichert</translation>
    </message>
    <message numerus="yes">
        <source>The path has %Ln place(s) now.</source>
        <translation>
            <numerusform>Die Bahn hat jetzt %Ln Punkt.</numerusform>
            <numerusform>Die Bahn hat jetzt %Ln Punkte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Place 1 of %1 was stored</source>
        <translation>Punkt 1 von %1 wurde gespeichert</translation>
    </message>
    <message>
        <source>The next places that are stored continue the path.</source>
        <translation>Die nächsten gespeicherten Punkte setzen die Bahn fort.</translation>
    </message>
    <message>
        <source>%1 was not changed</source>
        <translation>%1 wurde nicht geändert</translation>
    </message>
    <message numerus="yes">
        <source>%Ln point(s) checked.</source>
        <translation>
            <numerusform>%Ln Stelle geprüft.</numerusform>
            <numerusform>%Ln Stellen geprüft.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln path(s) proven</source>
        <translation>
            <numerusform>%Ln Bahn bewiesen</numerusform>
            <numerusform>%Ln Bahnen bewiesen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln not</source>
        <translation>
            <numerusform>%Ln nicht</numerusform>
            <numerusform>%Ln nicht</numerusform>
        </translation>
    </message>
    <message>
        <source>The list has what is known of the others.</source>
        <translation>Die Liste zeigt, was über die anderen bekannt ist.</translation>
    </message>
    <message>
        <source>%1 could not be planned again and was not changed</source>
        <translation>%1 konnte nicht neu geplant werden und wurde nicht geändert</translation>
    </message>
    <message>
        <source>Your changes were kept; the planned path is %1.</source>
        <translation>Ihre Änderungen wurden behalten; die geplante Bahn ist %1.</translation>
    </message>
    <message>
        <source>The result is not valid for the cell as it is now, and was discarded.</source>
        <translation>Das Ergebnis gilt nicht für die Zelle, wie sie jetzt ist, und wurde verworfen.</translation>
    </message>
    <message>
        <source>%1 is outdated</source>
        <translation>%1 ist veraltet</translation>
    </message>
    <message>
        <source>%1 is not proven as it is now</source>
        <translation>%1 ist so, wie sie jetzt ist, nicht bewiesen</translation>
    </message>
    <message>
        <source>Only what is proven free of collisions is exported.</source>
        <translation>Nur was bewiesen kollisionsfrei ist, wird exportiert.</translation>
    </message>
    <message>
        <source>Export it as it is</source>
        <translation>Unverändert exportieren</translation>
    </message>
    <message>
        <source>The name had no extension of a robot language, so that of %1 was added.</source>
        <translation>Der Name hatte keine Dateiendung einer Robotersprache, daher wurde die von %1 angefügt.</translation>
    </message>
    <message>
        <source>Store the current joint values under a name</source>
        <translation>Speichert die jetzigen Gelenkwerte unter einem Namen</translation>
    </message>
    <message>
        <source>Insert the current joint values after the selected place as a critical configuration; before the goal, if that or the path is selected</source>
        <translation>Fügt die jetzigen Gelenkwerte nach dem gewählten Punkt als kritische Stellung ein; vor dem Ziel der Bahn, wenn dieses oder die Bahn gewählt ist</translation>
    </message>
    <message>
        <source>Move the selected place towards the start of the path</source>
        <translation>Verschiebt den gewählten Punkt zum Anfang der Bahn hin</translation>
    </message>
    <message>
        <source>Move the selected place towards the end of the path</source>
        <translation>Verschiebt den gewählten Punkt zum Ende der Bahn hin</translation>
    </message>
    <message>
        <source>Verify that each motion of the selected path is free of collisions, or list all collisions; also if it was verified before</source>
        <translation>Prüft, ob jede Bewegung der gewählten Bahn kollisionsfrei ist, und listet sonst alle Kollisionen auf; auch wenn sie schon geprüft wurde</translation>
    </message>
    <message>
        <source>Verify the paths of all robots that are not verified in their current state, each with the other robots where they are</source>
        <translation>Die Bahnen aller Roboter prüfen, die in ihrem jetzigen Zustand nicht geprüft sind, jede mit den anderen Robotern, wo sie sind</translation>
    </message>
    <message>
        <source>Read the pairs of links that may touch, and named states, of the selected robot, or else of the one to plan for</source>
        <translation>Liest die Paare von Gliedern, die sich berühren dürfen, und benannte Stellungen: für den gewählten Roboter, sonst für den, für den geplant wird</translation>
    </message>
    <message>
        <source>Choose the order of the critical places, and the configurations in which they are reached, that take the least time</source>
        <translation>Wählt die Reihenfolge der kritischen Punkte und die Stellungen, in denen sie erreicht werden, so, dass die wenigste Zeit gebraucht wird</translation>
    </message>
    <message>
        <source>Plan for the selected robot from now on; the others stay where they are</source>
        <translation>Plant von jetzt an für den gewählten Roboter; die anderen bleiben stehen, wo sie sind</translation>
    </message>
    <message>
        <source>Choose the robot of the path first.</source>
        <translation>Wählen Sie zuerst den Roboter der Bahn.</translation>
    </message>
    <message>
        <source>The path is being verified.</source>
        <translation>Die Bahn wird geprüft.</translation>
    </message>
    <message>
        <source>Select the robot that the file describes, and read it again.</source>
        <translation>Wählen Sie den Roboter, den die Datei beschreibt, und lesen Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 is a path of another robot</source>
        <translation>%1 ist eine Bahn eines anderen Roboters</translation>
    </message>
    <message>
        <source>%1 is not in the plan any more</source>
        <translation>%1 ist nicht mehr im Plan</translation>
    </message>
    <message>
        <source>Nothing was done.</source>
        <translation>Es wurde nichts getan.</translation>
    </message>
    <message>
        <source>%1 was not exported</source>
        <translation>%1 wurde nicht exportiert</translation>
    </message>
    <message>
        <source>The path was changed since its export was asked for.</source>
        <translation>Die Bahn wurde geändert, seit der Export angefordert wurde.</translation>
    </message>
    <message>
        <source>Export it again.</source>
        <translation>Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message numerus="yes">
        <source>%Ln leg(s) with unchanged ends, still proven free, were kept.</source>
        <translation>
            <numerusform>%Ln Abschnitt mit unveränderten Enden, der weiterhin als frei bewiesen ist, wurde beibehalten.</numerusform>
            <numerusform>%Ln Abschnitte mit unveränderten Enden, die weiterhin als frei bewiesen sind, wurden beibehalten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Bezugssystem %1</translation>
    </message>
    <message>
        <source>Work in no frame</source>
        <translation>In keinem Bezugssystem arbeiten</translation>
    </message>
    <message>
        <source>Work in %1</source>
        <translation>In %1 arbeiten</translation>
    </message>
    <message>
        <source>what carried it was removed</source>
        <translation>was es trug, wurde entfernt</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>auf %1</translation>
    </message>
    <message>
        <source>for coordinates and programs</source>
        <translation>für Koordinaten und Programme</translation>
    </message>
    <message>
        <source>%1; for coordinates and programs</source>
        <translation>%1; für Koordinaten und Programme</translation>
    </message>
    <message>
        <source>Its places are in the frame %1.</source>
        <translation>Seine Orte stehen im Bezugssystem %1.</translation>
    </message>
    <message>
        <source>Store a &amp;frame here</source>
        <translation>&amp;Bezugssystem hier speichern</translation>
    </message>
    <message>
        <source>&amp;Work in the frame</source>
        <translation>Im Bezugssystem &amp;arbeiten</translation>
    </message>
    <message>
        <source>Store the current pose of the tool as a target; on the selected body, if any, or in the chosen frame, with which it moves</source>
        <translation>Die jetzige Lage des Werkzeugs als Ziel speichern; auf dem gewählten Körper, falls es einen gibt, oder im gewählten Bezugssystem, mit dem es sich bewegt</translation>
    </message>
    <message>
        <source>Store the current pose of the tool as a frame for targets and programs; on the selected body, if any, with which it moves</source>
        <translation>Die jetzige Lage des Werkzeugs als Bezugssystem für Ziele und Programme speichern; auf dem gewählten Körper, falls es einen gibt, mit dem es sich bewegt</translation>
    </message>
    <message>
        <source>Show coordinates of targets, and write programs, in the selected frame; once more: in none</source>
        <translation>Koordinaten der Ziele im gewählten Bezugssystem zeigen und Programme darin schreiben; noch einmal: in keinem</translation>
    </message>
    <message>
        <source>Give the selected configuration, path, target or frame another name</source>
        <translation>Der gewählten Stellung, der Bahn, dem Ziel oder dem Bezugssystem einen anderen Namen geben</translation>
    </message>
    <message>
        <source>Remove the selected configuration, path, place, target, frame or robot</source>
        <translation>Die gewählte Stellung, die Bahn, den Ort, das Ziel, das Bezugssystem oder den Roboter entfernen</translation>
    </message>
    <message>
        <source>Select a frame in the list first.</source>
        <translation>Wählen Sie zuerst ein Bezugssystem in der Liste.</translation>
    </message>
    <message>
        <source>Select a configuration, a path, a target or a frame first.</source>
        <translation>Wählen Sie zuerst eine Stellung, eine Bahn, ein Ziel oder ein Bezugssystem.</translation>
    </message>
    <message>
        <source>Select a configuration, a path, a place, a target, a frame or a robot first.</source>
        <translation>Wählen Sie zuerst eine Stellung, eine Bahn, einen Ort, ein Ziel, ein Bezugssystem oder einen Roboter.</translation>
    </message>
    <message>
        <source>Store %1 in %2</source>
        <translation>%1 in %2 speichern</translation>
    </message>
    <message>
        <source>Its frames are in the cell now: %1.</source>
        <translation>Seine Koordinatensysteme sind jetzt in der Zelle: %1.</translation>
    </message>
    <message>
        <source>It is in frames of the cell: %1.</source>
        <translation>Es steht in Koordinatensystemen der Zelle: %1.</translation>
    </message>
    <message>
        <source>There are too many frames in the cell for these: %1.</source>
        <translation>In der Zelle sind zu viele Koordinatensysteme für diese: %1.</translation>
    </message>
    <message>
        <source>%1 was opened</source>
        <translation>%1 wurde geöffnet</translation>
    </message>
    <message>
        <source>To write programs in one of its frames again, choose to work in it.</source>
        <translation>Um Programme wieder in einem seiner Koordinatensysteme zu schreiben, wählen Sie, darin zu arbeiten.</translation>
    </message>
    <message>
        <source>&amp;Allow pairs to touch…</source>
        <translation>Berührung von Paaren &amp;erlauben …</translation>
    </message>
    <message>
        <source>A comment of the program says so.</source>
        <translation>Ein Kommentar des Programms sagt es.</translation>
    </message>
    <message>
        <source>&amp;Declare the frame in RAPID programs</source>
        <translation>Koordinatensystem in RAPID-Programmen &amp;deklarieren</translation>
    </message>
    <message>
        <source>Allow &amp;pairs to touch…</source>
        <translation>Berührung von &amp;Paaren erlauben …</translation>
    </message>
    <message>
        <source>Write the data of the frame (wobjdata) into each RAPID program; two modules of one task must not both have them</source>
        <translation>Die Daten des Koordinatensystems (wobjdata) in jedes RAPID-Programm schreiben; zwei Module eines Tasks dürfen sie nicht beide haben</translation>
    </message>
    <message>
        <source>Choose which of the pairs that meet here, or on the selected path, may touch; or no longer</source>
        <translation>Wählen, welche der Paare, die sich hier oder auf der gewählten Bahn treffen, sich berühren dürfen oder nicht mehr</translation>
    </message>
    <message>
        <source>Change the pairs that may touch</source>
        <translation>Paare ändern, die sich berühren dürfen</translation>
    </message>
    <message>
        <source>&amp;Show the first on the time line</source>
        <translation>Die erste auf der Zeitleiste &amp;zeigen</translation>
    </message>
    <message numerus="yes">
        <source>%Ln blend(s) became exact stops, as not every way within their zones is proven free.</source>
        <translation>
            <numerusform>%Ln Überschleifen wurde zum genauen Halt, da nicht jeder Weg in seiner Zone bewiesen frei ist.</numerusform>
            <numerusform>%Ln Überschleifen wurden zu genauen Halten, da nicht jeder Weg in ihren Zonen bewiesen frei ist.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not checked, as they may touch: %1.</source>
        <translation>Nicht geprüft, da sie sich berühren dürfen: %1.</translation>
    </message>
    <message>
        <source>Replace the selected configuration, place, target or frame by the current position of the robot</source>
        <translation>Die gewählte Konfiguration, Stelle, Zielpose oder das Koordinatensystem durch die jetzige Stellung des Roboters ersetzen</translation>
    </message>
    <message>
        <source>Select a configuration, a place of a path, a target or a frame first.</source>
        <translation>Zuerst eine Konfiguration, eine Stelle einer Bahn, eine Zielpose oder ein Koordinatensystem wählen.</translation>
    </message>
    <message>
        <source>%1 was removed</source>
        <translation>%1 wurde entfernt</translation>
    </message>
    <message numerus="yes">
        <source>%Ln path(s) keep its joint values: %1.</source>
        <translation>
            <numerusform>%Ln Bahn behält seine Gelenkwerte: %1.</numerusform>
            <numerusform>%Ln Bahnen behalten seine Gelenkwerte: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Undo brings it back.</source>
        <translation>Rückgängig bringt es zurück.</translation>
    </message>
    <message>
        <source>&amp;Let %1 touch %2</source>
        <translation>%1 darf %2 &amp;berühren</translation>
    </message>
    <message>
        <source>Its curve turns to and fro again and again, as edges of scanned parts do: follow a section or a drawn curve, or set a larger tolerance.</source>
        <translation>Die Kurve wendet sich immer wieder hin und her, wie Kanten gescannter Teile: Folgen Sie einem Schnitt oder einer gezeichneten Kurve, oder setzen Sie eine größere Toleranz.</translation>
    </message>
    <message>
        <source>&amp;Go to place %1</source>
        <translation>&amp;Zum Punkt %1 gehen</translation>
    </message>
    <message>
        <source>&amp;Go to %1</source>
        <translation>&amp;Zu %1 gehen</translation>
    </message>
    <message numerus="yes">
        <source>%Ln blend(s) became smaller: a blend has half of the shorter motion beside it at most, and only where it is proven free.</source>
        <translation>
            <numerusform>%Ln Überschleifen wurde kleiner: es hat höchstens die Hälfte der kürzeren Bewegung daneben, und nur, wo es bewiesen frei ist.</numerusform>
            <numerusform>%Ln Überschleifen wurden kleiner: jedes hat höchstens die Hälfte der kürzeren Bewegung daneben, und nur, wo es bewiesen frei ist.</numerusform>
        </translation>
    </message>
    <message>
        <source>Write it without these lines</source>
        <translation>Ohne diese Zeilen schreiben</translation>
    </message>
    <message>
        <source>Write exact stops instead</source>
        <translation>Stattdessen genaue Halte schreiben</translation>
    </message>
    <message numerus="yes">
        <source>%Ln blend(s) became exact stops, as %1 has none there; the program takes about %2 s.</source>
        <translation>
            <numerusform>%Ln Überschleifen wurde zum Genauhalt, da %1 dort keines hat; das Programm dauert etwa %2 s.</numerusform>
            <numerusform>%Ln Überschleifbereiche wurden zu Genauhalten, da %1 dort keine hat; das Programm dauert etwa %2 s.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln line(s) of the opened program, as outputs and waiting, were left out: the head of the program has their numbers.</source>
        <translation>
            <numerusform>%Ln Zeile des geöffneten Programms, wie Ausgänge und Warten, wurde weggelassen: Der Kopf des Programms hat ihre Nummer.</numerusform>
            <numerusform>%Ln Zeilen des geöffneten Programms, wie Ausgänge und Warten, wurden weggelassen: Der Kopf des Programms hat ihre Nummern.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handwheel::CellReachOutline</name>
    <message>
        <source>Show the r&amp;each of the arm</source>
        <translation>Rei&amp;chweite des Arms zeigen</translation>
    </message>
    <message>
        <source>Show what the tool&apos;s centre point reaches within the joint limits, in the upright plane of the tool</source>
        <translation>Zeigen, was der Werkzeugmittelpunkt innerhalb der Gelenkgrenzen erreicht, in der senkrechten Ebene des Werkzeugs</translation>
    </message>
    <message>
        <source>Finding the reach of the arm</source>
        <translation>Reichweite des Arms wird ermittelt</translation>
    </message>
</context>
<context>
    <name>handwheel::CellRobots</name>
    <message>
        <source>Robot:</source>
        <translation>Roboter:</translation>
    </message>
    <message>
        <source>Add a robot from a &amp;file…</source>
        <translation>Roboter aus einer &amp;Datei hinzufügen…</translation>
    </message>
    <message>
        <source>Add a bu&amp;ilt-in robot…</source>
        <translation>M&amp;itgelieferten Roboter hinzufügen…</translation>
    </message>
    <message>
        <source>Remo&amp;ve the robot</source>
        <translation>Robo&amp;ter entfernen</translation>
    </message>
    <message>
        <source>Add another robot to the cell, by its URDF or a table after Denavit and Hartenberg</source>
        <translation>Einen weiteren Roboter zur Zelle hinzufügen, aus seiner URDF-Datei oder einer Tabelle nach Denavit und Hartenberg</translation>
    </message>
    <message>
        <source>Add another robot to the cell from the library</source>
        <translation>Einen weiteren Roboter aus der Bibliothek zur Zelle hinzufügen</translation>
    </message>
    <message>
        <source>Open a robot cell first.</source>
        <translation>Öffnen Sie zuerst eine Roboterzelle.</translation>
    </message>
    <message>
        <source>It is the only robot of the cell.</source>
        <translation>Er ist der einzige Roboter der Zelle.</translation>
    </message>
    <message>
        <source>Plan for %1</source>
        <translation>Für %1 planen</translation>
    </message>
    <message>
        <source>Remove the robot %1</source>
        <translation>Roboter %1 entfernen</translation>
    </message>
    <message>
        <source>Add a robot</source>
        <translation>Roboter hinzufügen</translation>
    </message>
    <message>
        <source>Robots (*.urdf *.dh.json);;All files (*)</source>
        <translation>Roboter (*.urdf *.dh.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Add the robot %1</source>
        <translation>Roboter %1 hinzufügen</translation>
    </message>
    <message>
        <source>%1 was removed</source>
        <translation>%1 wurde entfernt</translation>
    </message>
    <message>
        <source>Remove the selected robot, or else the one to plan for, with its configurations and paths</source>
        <translation>Den ausgewählten Roboter entfernen, sonst den, für den geplant wird, mit seinen Stellungen und Bahnen</translation>
    </message>
    <message>
        <source>Robot to plan for</source>
        <translation>Roboter, für den geplant wird</translation>
    </message>
    <message>
        <source>The robot to plan for; the others stay where they are</source>
        <translation>Der Roboter, für den geplant wird; die anderen bleiben stehen, wo sie sind</translation>
    </message>
    <message>
        <source>%1 configurations and %2 paths were removed with it. Undo restores them.</source>
        <translation>%1 Stellungen und %2 Bahnen wurden mit ihm entfernt. „Rückgängig“ stellt sie wieder her.</translation>
    </message>
    <message>
        <source>The robots were not changed</source>
        <translation>Die Roboter wurden nicht geändert</translation>
    </message>
</context>
<context>
    <name>handwheel::CellTargets</name>
    <message>
        <source>Searching configurations for the targets</source>
        <translation>Stellungen für die Ziele werden gesucht</translation>
    </message>
    <message>
        <source>its body was removed</source>
        <translation>sein Körper wurde entfernt</translation>
    </message>
    <message>
        <source>its frame is on nothing</source>
        <translation>sein Koordinatensystem ist auf nichts</translation>
    </message>
    <message>
        <source>out of reach</source>
        <translation>außer Reichweite</translation>
    </message>
    <message numerus="yes">
        <source>%Ln configuration(s)</source>
        <translation>
            <numerusform>%Ln Konfiguration</numerusform>
            <numerusform>%Ln Konfigurationen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (on %2)</source>
        <translation>%1 (auf %2)</translation>
    </message>
    <message>
        <source>%1 (in %2)</source>
        <translation>%1 (in %2)</translation>
    </message>
</context>
<context>
    <name>handwheel::ClayLayersView</name>
    <message>
        <source>La&amp;yers</source>
        <translation>&amp;Ebenen</translation>
    </message>
    <message>
        <source>Sculpt in layers that can be weakened and turned off</source>
        <translation>In Ebenen modellieren, die sich abschwächen und ausschalten lassen</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Layers, the topmost first</source>
        <translation>Ebenen, die oberste zuerst</translation>
    </message>
    <message>
        <source>Strength of the layer</source>
        <translation>Stärke der Ebene</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a layer on top</source>
        <translation>Obenauf eine Ebene hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Take the layer and its strokes away</source>
        <translation>Die Ebene mit ihren Strichen entfernen</translation>
    </message>
    <message>
        <source>Merge down</source>
        <translation>Nach unten verschmelzen</translation>
    </message>
    <message>
        <source>Make the layer one with that below it, or with the volume, as it is visible now</source>
        <translation>Die Ebene, wie sie jetzt sichtbar ist, mit der darunter oder mit dem Volumen vereinen</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Remove layer</source>
        <translation>Ebene entfernen</translation>
    </message>
    <message>
        <source>Merge layer</source>
        <translation>Ebene verschmelzen</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Strokes change the volume itself.</source>
        <translation>Striche ändern das Volumen selbst.</translation>
    </message>
    <message>
        <source>Strokes go on the top layer.</source>
        <translation>Striche kommen auf die oberste Ebene.</translation>
    </message>
    <message>
        <source>The top layer takes no strokes while it is off or weaker than 100 %.</source>
        <translation>Die oberste Ebene nimmt keine Striche an, solange sie aus ist oder schwächer als 100 %.</translation>
    </message>
    <message>
        <source>Drilling and changes of the whole volume apply all layers.</source>
        <translation>Bohren und Änderungen des ganzen Volumens wenden alle Ebenen an.</translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation>Ebene hinzufügen</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>Ebene %1</translation>
    </message>
    <message>
        <source>The layer stays as it is</source>
        <translation>Die Ebene bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>The top layer takes no strokes</source>
        <translation>Die oberste Ebene nimmt keine Striche an</translation>
    </message>
    <message>
        <source>“%1” is off, or its strength is below 100 %.</source>
        <translation>„%1“ ist aus, oder ihre Stärke liegt unter 100 %.</translation>
    </message>
    <message>
        <source>Turn it on at full strength, or add a layer: the panel Layers has both.</source>
        <translation>Schalten Sie sie mit voller Stärke ein, oder fügen Sie eine Ebene hinzu: Das Feld „Ebenen“ hat beides.</translation>
    </message>
    <message>
        <source>Computing the layer</source>
        <translation>Ebene wird berechnet</translation>
    </message>
</context>
<context>
    <name>handwheel::ColourRow</name>
    <message>
        <source>Choose a colour…</source>
        <translation>Farbe wählen…</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>Wählen: %1</translation>
    </message>
</context>
<context>
    <name>handwheel::CommandModel</name>
    <message>
        <source>Not possible now</source>
        <translation>Jetzt nicht möglich</translation>
    </message>
</context>
<context>
    <name>handwheel::CommandPalette</name>
    <message>
        <source>&amp;Search commands…</source>
        <translation>Befehle &amp;suchen…</translation>
    </message>
    <message>
        <source>Find and run any command by its name (Ctrl+K)</source>
        <translation>Jeden Befehl am Namen finden und ausführen (Strg+K)</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Befehle suchen</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>Gefundene Befehle</translation>
    </message>
    <message>
        <source>No matching command.</source>
        <translation>Kein passender Befehl.</translation>
    </message>
</context>
<context>
    <name>handwheel::ControlButton</name>
    <message>
        <source>Control</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Settings of the control that the program does not tell: decimal points and block skips</source>
        <translation>Einstellungen der Steuerung, die das Programm nicht nennt: Dezimalpunkte und Satzausblendungen</translation>
    </message>
    <message>
        <source>A length without a decimal point counts 0.001 mm or 0.0001 inch</source>
        <translation>Eine Länge ohne Dezimalpunkt zählt 0,001 mm oder 0,0001 Zoll</translation>
    </message>
    <message>
        <source>Skip blocks with / or /1</source>
        <translation>Sätze mit / oder /1 ausblenden</translation>
    </message>
    <message>
        <source>Skip blocks with /%1</source>
        <translation>Sätze mit /%1 ausblenden</translation>
    </message>
</context>
<context>
    <name>handwheel::CopyActions</name>
    <message>
        <source>Open a copy as %1</source>
        <translation>Kopie als %1 öffnen</translation>
    </message>
    <message>
        <source>Open the surface of this document as a new document of that kind</source>
        <translation>Die Oberfläche dieses Dokuments als neues Dokument dieser Art öffnen</translation>
    </message>
    <message>
        <source>Copying %1</source>
        <translation>%1 wird kopiert</translation>
    </message>
    <message>
        <source>%1 was not copied</source>
        <translation>%1 wurde nicht kopiert</translation>
    </message>
</context>
<context>
    <name>handwheel::DefectActions</name>
    <message>
        <source>&amp;Cut and close</source>
        <translation>Schneiden &amp;und schließen</translation>
    </message>
    <message>
        <source>Fix</source>
        <translation>Beheben</translation>
    </message>
    <message>
        <source>&amp;Thicken sheets</source>
        <translation>&amp;Flächen aufdicken</translation>
    </message>
    <message>
        <source>Fix the defects selected in the list</source>
        <translation>Die in der Liste ausgewählten Fehler beheben</translation>
    </message>
    <message>
        <source>Close the hole across the part, and cut the part where the patch intersects it</source>
        <translation>Das Loch quer durch das Teil schließen und das Teil schneiden, wo die Füllfläche es durchdringt</translation>
    </message>
    <message>
        <source>Reverse &amp;inside-out bodies</source>
        <translation>Umgestülpte &amp;Körper umkehren</translation>
    </message>
    <message>
        <source>Resolve &amp;self-intersections</source>
        <translation>&amp;Selbstdurchdringungen auflösen</translation>
    </message>
    <message>
        <source>Reverse all bodies whose triangles face inwards</source>
        <translation>Alle Körper umkehren, deren Dreiecke nach innen zeigen</translation>
    </message>
    <message>
        <source>Cut all triangles that intersect apart, and join the rest</source>
        <translation>Alle sich durchdringenden Dreiecke zerschneiden und den Rest verbinden</translation>
    </message>
    <message>
        <source>Turn open sheets into thin closed bodies: the selected one, or all. A body grows to the side opposite to the normals; the triangles of the sheet stay where they are</source>
        <translation>Offene Flächen zu dünnen geschlossenen Körpern machen: die ausgewählte oder alle. Ein Körper wächst zur Seite entgegen den Normalen; die Dreiecke der Fläche bleiben, wo sie sind</translation>
    </message>
    <message>
        <source>&amp;Thicken sheets by %1</source>
        <translation>Flächen um %1 &amp;verdicken</translation>
    </message>
    <message>
        <source>&amp;Unite bodies</source>
        <translation>Körper &amp;vereinigen</translation>
    </message>
    <message>
        <source>Make one body of those that intersect or lie inside each other, and remove what lies inside of it</source>
        <translation>Macht einen Körper aus denen, die sich schneiden oder ineinander liegen, und entfernt, was darin liegt</translation>
    </message>
    <message>
        <source>Self-intersections are still being searched for.</source>
        <translation>Selbstdurchdringungen werden noch gesucht.</translation>
    </message>
    <message>
        <source>There is no open sheet.</source>
        <translation>Es gibt keine offene Fläche.</translation>
    </message>
    <message>
        <source>The selected hole is not the outer boundary of a sheet.</source>
        <translation>Das ausgewählte Loch ist nicht der Außenrand einer Fläche.</translation>
    </message>
    <message>
        <source>No body faces inwards.</source>
        <translation>Kein Körper zeigt nach innen.</translation>
    </message>
    <message>
        <source>There are no self-intersections.</source>
        <translation>Es gibt keine Selbstdurchdringungen.</translation>
    </message>
    <message>
        <source>No bodies intersect or lie inside each other.</source>
        <translation>Keine Körper durchdringen sich oder liegen ineinander.</translation>
    </message>
</context>
<context>
    <name>handwheel::DefectCard</name>
    <message>
        <source>Remains: %1.</source>
        <translation>Es bleibt: %1.</translation>
    </message>
</context>
<context>
    <name>handwheel::DefectList</name>
    <message numerus="yes">
        <source>%Ln edge(s), %1</source>
        <translation>
            <numerusform>%Ln Kante, %1</numerusform>
            <numerusform>%Ln Kanten, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>Area %1.</source>
        <translation>Flächeninhalt %1.</translation>
    </message>
    <message>
        <source>%1 from the best-fitting plane (RMS).</source>
        <translation>%1 Abweichung von der Ausgleichsebene (RMS).</translation>
    </message>
    <message numerus="yes">
        <source>%Ln island(s) inside: Repair all joins them to the patch, Fill alone covers them.</source>
        <translation>
            <numerusform>%Ln Insel darin: „Alles reparieren“ verbindet sie mit der Füllung, „Füllen“ allein deckt sie zu.</numerusform>
            <numerusform>%Ln Inseln darin: „Alles reparieren“ verbindet sie mit der Füllung, „Füllen“ allein deckt sie zu.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handwheel::DefectModel</name>
    <message>
        <source>searching…</source>
        <translation>Suche läuft…</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1: searching</source>
        <translation>%1: Suche läuft</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Stayed open: %1.</source>
        <translation>Blieb offen: %1.</translation>
    </message>
    <message>
        <source>Edge %1</source>
        <translation>Kante %1</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>Eckpunkt %1</translation>
    </message>
    <message>
        <source>Triangle %1</source>
        <translation>Dreieck %1</translation>
    </message>
    <message>
        <source>Piece %1</source>
        <translation>Stück %1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s)</source>
        <translation>
            <numerusform>%Ln Dreieck</numerusform>
            <numerusform>%Ln Dreiecke</numerusform>
        </translation>
    </message>
    <message>
        <source>Pair %1</source>
        <translation>Paar %1</translation>
    </message>
    <message>
        <source>Body %1</source>
        <translation>Körper %1</translation>
    </message>
    <message numerus="yes">
        <source>Here that is %Ln triangle(s), %1 % of all.</source>
        <translation>
            <numerusform>Hier ist das %Ln Dreieck, %1 % von allen.</numerusform>
            <numerusform>Hier sind das %Ln Dreiecke, %1 % von allen.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2, before the repair %3</source>
        <translation>%1: %2, vor der Reparatur %3</translation>
    </message>
    <message>
        <source>Remains: %1.</source>
        <translation>Bleibt: %1.</translation>
    </message>
    <message>
        <source>Last repair: %1.</source>
        <translation>Letzte Reparatur: %1.</translation>
    </message>
    <message>
        <source>%1; remains: %2</source>
        <translation>%1; bleibt: %2</translation>
    </message>
</context>
<context>
    <name>handwheel::DefectsPanel</name>
    <message>
        <source>Defects</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Open a mesh to see its holes and other defects here.</source>
        <translation>Öffnen Sie ein Netz, um hier seine Löcher und anderen Fehler zu sehen.</translation>
    </message>
</context>
<context>
    <name>handwheel::DeviationPanel</name>
    <message>
        <source>Back to the defects</source>
        <translation>Zurück zu den Fehlern</translation>
    </message>
    <message>
        <source>Compare with another file…</source>
        <translation>Mit anderer Datei vergleichen…</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>90 % within</source>
        <translation>90 % innerhalb</translation>
    </message>
    <message>
        <source>99 % within</source>
        <translation>99 % innerhalb</translation>
    </message>
    <message>
        <source>Colours up to</source>
        <translation>Farben bis</translation>
    </message>
    <message>
        <source>Under the pointer</source>
        <translation>Unter dem Zeiger</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>Bericht speichern…</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Deviation from the mesh as it was opened</source>
        <translation>Abweichung vom Netz, wie es geöffnet wurde</translation>
    </message>
    <message>
        <source>Deviation from %1</source>
        <translation>Abweichung von %1</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Share of the area</source>
        <translation>Anteil der Fläche</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Histogram of the deviation</source>
        <translation>Histogramm der Abweichung</translation>
    </message>
    <message>
        <source>Zoom to this place</source>
        <translation>Auf diese Stelle zoomen</translation>
    </message>
    <message>
        <source>Remove the colours</source>
        <translation>Farben wegnehmen</translation>
    </message>
</context>
<context>
    <name>handwheel::DeviationView</name>
    <message>
        <source>De&amp;viation…</source>
        <translation>Abwei&amp;chung…</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>Vergleich läuft…</translation>
    </message>
    <message>
        <source>Comparing %1</source>
        <translation>%1 wird verglichen</translation>
    </message>
    <message>
        <source>Compared %1: largest distance %2 mm</source>
        <translation>%1 verglichen: größter Abstand %2 mm</translation>
    </message>
    <message>
        <source>The meshes could not be compared</source>
        <translation>Die Netze konnten nicht verglichen werden</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Report (*.pdf *.html *.json)</source>
        <translation>Bericht (*.pdf *.html *.json)</translation>
    </message>
    <message>
        <source>as it was opened</source>
        <translation>wie geöffnet</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Saved the report %1</source>
        <translation>Bericht %1 gespeichert</translation>
    </message>
    <message>
        <source>%1 has no pictures</source>
        <translation>%1 hat keine Bilder</translation>
    </message>
    <message>
        <source>%1 could not be saved</source>
        <translation>%1 konnte nicht gespeichert werden</translation>
    </message>
    <message>
        <source>Show the deviation of the mesh from the opened file in colours</source>
        <translation>Die Abweichung des Netzes von der geöffneten Datei in Farben zeigen</translation>
    </message>
</context>
<context>
    <name>handwheel::DeviceCard</name>
    <message>
        <source>No device in use</source>
        <translation>Kein Gerät in Gebrauch</translation>
    </message>
    <message>
        <source>The pointer is outside the view</source>
        <translation>Der Zeiger ist außerhalb der Ansicht</translation>
    </message>
    <message>
        <source>Plug one in: it appears here by itself.</source>
        <translation>Schließen Sie eines an: Es erscheint hier von selbst.</translation>
    </message>
    <message>
        <source>Choose one from the list above.</source>
        <translation>Wählen Sie eines aus der Liste oben.</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>Kein Gerät</translation>
    </message>
    <message>
        <source>Look for devices again</source>
        <translation>Noch einmal nach Geräten suchen</translation>
    </message>
    <message>
        <source>Not in real time: what to do</source>
        <translation>Nicht in Echtzeit: was zu tun ist</translation>
    </message>
    <message>
        <source>%1 (unplugged)</source>
        <translation>%1 (abgezogen)</translation>
    </message>
    <message>
        <source>Simulates at the mouse pointer what a device would feel. The mouse also points and rotates the view without this.</source>
        <translation>Simuliert am Mauszeiger, was ein Gerät fühlen würde. Die Maus zeigt und dreht die Ansicht auch ohne dies.</translation>
    </message>
    <message>
        <source>%1 moves the view. Choose it above only if it is to move the tip.</source>
        <translation>%1 bewegt die Ansicht. Wählen Sie es oben nur, wenn es die Spitze bewegen soll.</translation>
    </message>
    <message>
        <source>Ticks are late when the computer is busy, and the stiffness is reduced to allow for that</source>
        <translation>Wenn der Rechner ausgelastet ist, kommen Takte zu spät; die Steifigkeit ist daher verringert</translation>
    </message>
</context>
<context>
    <name>handwheel::DeviceFinder</name>
    <message>
        <source>Looking for devices</source>
        <translation>Geräte werden gesucht</translation>
    </message>
</context>
<context>
    <name>handwheel::DevicePanel</name>
    <message>
        <source>No device is in use.</source>
        <translation>Kein Gerät ist in Gebrauch.</translation>
    </message>
    <message>
        <source>About the device</source>
        <translation>Über das Gerät</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <source>Timing</source>
        <translation>Takt</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Safety: the force is not limited.</source>
        <translation>Sicherheit: Die Kraft ist nicht begrenzt.</translation>
    </message>
</context>
<context>
    <name>handwheel::DimensionsView</name>
    <message>
        <source>Dimensions in the &amp;view</source>
        <translation>&amp;Maße in der Ansicht</translation>
    </message>
    <message>
        <source>Show diameters, lengths, radii and chamfers of the part in the view</source>
        <translation>Durchmesser, Längen, Radien und Fasen des Teils in der Ansicht zeigen</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Teil wird gemessen</translation>
    </message>
</context>
<context>
    <name>handwheel::DockTitle</name>
    <message>
        <source>Dock this panel</source>
        <translation>Dieses Feld andocken</translation>
    </message>
    <message>
        <source>Undock this panel</source>
        <translation>Dieses Feld abdocken</translation>
    </message>
    <message>
        <source>Dock the panel “%1”</source>
        <translation>Feld „%1“ andocken</translation>
    </message>
    <message>
        <source>Undock the panel “%1”</source>
        <translation>Feld „%1“ abdocken</translation>
    </message>
    <message>
        <source>Hide this panel</source>
        <translation>Dieses Feld ausblenden</translation>
    </message>
    <message>
        <source>Hide the panel “%1”</source>
        <translation>Feld „%1“ ausblenden</translation>
    </message>
</context>
<context>
    <name>handwheel::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation>%1 von %2 ändern</translation>
    </message>
</context>
<context>
    <name>handwheel::DocumentTabs</name>
    <message>
        <source>Open documents</source>
        <translation>Offene Dokumente</translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation>%1 schließen</translation>
    </message>
</context>
<context>
    <name>handwheel::DocumentsPanel</name>
    <message>
        <source>Open documents</source>
        <translation>Offene Dokumente</translation>
    </message>
    <message>
        <source>Hide the surface</source>
        <translation>Oberfläche ausblenden</translation>
    </message>
    <message>
        <source>Show the surface</source>
        <translation>Oberfläche einblenden</translation>
    </message>
    <message>
        <source>%1, not saved</source>
        <translation>%1, nicht gespeichert</translation>
    </message>
    <message>
        <source>%1, hidden</source>
        <translation>%1, ausgeblendet</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Ausgeblendet</translation>
    </message>
    <message>
        <source>Hide or show the d&amp;ocument</source>
        <translation>D&amp;okument aus- oder einblenden</translation>
    </message>
</context>
<context>
    <name>handwheel::DrillView</name>
    <message>
        <source>Breakthrough: stop. %1 mm beyond</source>
        <translation>Durchbruch: anhalten. %1 mm darüber hinaus</translation>
    </message>
    <message>
        <source>%1 mm beside the planned path</source>
        <translation>%1 mm neben der geplanten Bahn</translation>
    </message>
    <message>
        <source>Drilling</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>Drilling…</source>
        <translation>Es wird gebohrt…</translation>
    </message>
    <message>
        <source>%1 mm deep, %2 N, %3 N·mm, +%4 K (estimate)</source>
        <translation>%1 mm tief, %2 N, %3 N·mm, +%4 K (Schätzung)</translation>
    </message>
    <message>
        <source>The drill entered the forbidden region.</source>
        <translation>Der Bohrer ist in den verbotenen Bereich eingedrungen.</translation>
    </message>
    <message>
        <source>Beside the planned path</source>
        <translation>Neben der geplanten Bahn</translation>
    </message>
    <message>
        <source>The drill is more than %1 mm away from it.</source>
        <translation>Der Bohrer ist mehr als %1 mm von ihr entfernt.</translation>
    </message>
    <message>
        <source>Breakthrough</source>
        <translation>Durchbruch</translation>
    </message>
    <message>
        <source>The drill is through after %1 s.</source>
        <translation>Der Bohrer ist nach %1 s durch.</translation>
    </message>
    <message>
        <source>The forbidden region was entered by %1 mm: this attempt has failed</source>
        <translation>%1 mm in den verbotenen Bereich eingedrungen: Dieser Versuch ist nicht bestanden</translation>
    </message>
    <message>
        <source>The attempt has failed</source>
        <translation>Der Versuch ist nicht bestanden</translation>
    </message>
    <message>
        <source>Release the button, undo the hole, and begin where the green rod meets the surface.</source>
        <translation>Lassen Sie die Taste los, machen Sie das Bohrloch rückgängig, und beginnen Sie, wo der grüne Stab auf die Oberfläche trifft.</translation>
    </message>
    <message>
        <source>Release the button now: each further millimetre counts.</source>
        <translation>Lassen Sie die Taste jetzt los: Jeder weitere Millimeter zählt.</translation>
    </message>
    <message>
        <source>Hold the button on the part to drill</source>
        <translation>Zum Bohren die Taste auf dem Teil halten</translation>
    </message>
    <message>
        <source>Breakthrough, %1 mm beyond</source>
        <translation>Durchbruch, %1 mm darüber hinaus</translation>
    </message>
    <message>
        <source>Undo the hole to try again, and stop at the breakthrough. The report lists this try.</source>
        <translation>Machen Sie das Bohrloch rückgängig, um es noch einmal zu versuchen, und halten Sie beim Durchbruch an. Der Bericht führt diesen Versuch auf.</translation>
    </message>
</context>
<context>
    <name>handwheel::ExerciseEditor</name>
    <message>
        <source>Add what is marked</source>
        <translation>Bewertetes hinzufügen</translation>
    </message>
    <message>
        <source>Add a step</source>
        <translation>Einen Schritt hinzufügen</translation>
    </message>
    <message>
        <source>Remove a criterion</source>
        <translation>Ein Kriterium entfernen</translation>
    </message>
    <message>
        <source>Remove a step</source>
        <translation>Einen Schritt entfernen</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Criteria</source>
        <translation>Kriterien</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Add a criterion</source>
        <translation>Ein Kriterium hinzufügen</translation>
    </message>
    <message>
        <source>Move a criterion</source>
        <translation>Ein Kriterium verschieben</translation>
    </message>
    <message>
        <source>Move a step</source>
        <translation>Einen Schritt verschieben</translation>
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
        <source>Remove the selected row</source>
        <translation>Die gewählte Zeile entfernen</translation>
    </message>
    <message>
        <source>Move the selected row up</source>
        <translation>Die gewählte Zeile nach oben verschieben</translation>
    </message>
    <message>
        <source>Move the selected row down</source>
        <translation>Die gewählte Zeile nach unten verschieben</translation>
    </message>
    <message>
        <source>Choose the criteria of a step</source>
        <translation>Kriterien eines Schritts wählen</translation>
    </message>
    <message>
        <source>New hint</source>
        <translation>Neuer Hinweis</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 Punkt</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>Add %Ln size(s) of the target</source>
        <translation>
            <numerusform>%Ln Maß des Ziels hinzufügen</numerusform>
            <numerusform>%Ln Maße des Ziels hinzufügen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All %Ln size(s) of the target</source>
        <translation>
            <numerusform>%Ln Maß des Ziels</numerusform>
            <numerusform>Alle %Ln Maße des Ziels</numerusform>
        </translation>
    </message>
    <message>
        <source>A size of the target</source>
        <translation>Ein Maß des Ziels</translation>
    </message>
    <message>
        <source>Add a hint</source>
        <translation>Einen Hinweis hinzufügen</translation>
    </message>
    <message>
        <source>Change a hint</source>
        <translation>Einen Hinweis ändern</translation>
    </message>
    <message>
        <source>Remove a hint</source>
        <translation>Einen Hinweis entfernen</translation>
    </message>
    <message>
        <source>Points: %1</source>
        <translation>Punkte: %1</translation>
    </message>
</context>
<context>
    <name>handwheel::ExerciseLesson</name>
    <message>
        <source>&amp;Begin</source>
        <translation>Begi&amp;nnen</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Hand in…</source>
        <translation>Abg&amp;eben…</translation>
    </message>
    <message>
        <source>Measure the sizes of the drawing on the part as it is now</source>
        <translation>Die Maße der Zeichnung am jetzigen Teil messen</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Ihr Name</translation>
    </message>
    <message>
        <source>: %1 … %2%3</source>
        <translation>: %1 … %2%3</translation>
    </message>
    <message>
        <source>: at most %1%2</source>
        <translation>: höchstens %1%2</translation>
    </message>
    <message>
        <source>: at least %1%2</source>
        <translation>: mindestens %1%2</translation>
    </message>
    <message>
        <source>Save a file for the teacher, with the part and all of its passes</source>
        <translation>Eine Datei für die Lehrkraft speichern, mit dem Teil und allen seinen Schnitten</translation>
    </message>
    <message>
        <source>Write your name above first</source>
        <translation>Tragen Sie zuerst oben Ihren Namen ein</translation>
    </message>
    <message>
        <source>between the faces at Z %1 mm and Z %2 mm</source>
        <translation>zwischen den Stirnflächen bei Z %1 mm und Z %2 mm</translation>
    </message>
    <message>
        <source>The work was changed since; measured before that:</source>
        <translation>Das Werk wurde seitdem geändert; davor gemessen:</translation>
    </message>
</context>
<context>
    <name>handwheel::ExerciseUi</name>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Beginnen</translation>
    </message>
    <message>
        <source>Open the stock and work on the exercise, step by step</source>
        <translation>Das Rohteil öffnen und die Übung Schritt für Schritt bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Student&apos;s copy</source>
        <translation>&amp;Schülerfassung</translation>
    </message>
    <message>
        <source>Open the exercise as students see it; save it for them</source>
        <translation>Die Übung öffnen, wie Schüler sie sehen; für sie speichern</translation>
    </message>
    <message>
        <source>Take as model s&amp;olution</source>
        <translation>Als &amp;Musterlösung übernehmen</translation>
    </message>
    <message>
        <source>Take as &amp;target</source>
        <translation>Als &amp;Ziel übernehmen</translation>
    </message>
    <message>
        <source>Make the shape of that work the target of the exercise</source>
        <translation>Die Form dieser Arbeit zum Ziel der Übung machen</translation>
    </message>
    <message>
        <source>&amp;Mark…</source>
        <translation>Be&amp;werten…</translation>
    </message>
    <message>
        <source>Mark files that students have handed in</source>
        <translation>Dateien bewerten, die Schüler abgegeben haben</translation>
    </message>
    <message>
        <source>New e&amp;xercise</source>
        <translation>Neue &amp;Übung</translation>
    </message>
    <message>
        <source>Prepare an exercise for students</source>
        <translation>Eine Übung für Schüler vorbereiten</translation>
    </message>
    <message>
        <source>First &amp;lesson at the lathe</source>
        <translation>Erste &amp;Lektion an der Drehmaschine</translation>
    </message>
    <message>
        <source>Turn your first shoulder</source>
        <translation>Den ersten Absatz drehen</translation>
    </message>
    <message>
        <source>Exercise: shaft with shoulders</source>
        <translation>Übung: Welle mit Absätzen</translation>
    </message>
    <message>
        <source>Exercise: bored bush</source>
        <translation>Übung: Buchse mit Bohrung</translation>
    </message>
    <message>
        <source>Exercise: ball</source>
        <translation>Übung: Kugel</translation>
    </message>
    <message>
        <source>Exercise: gourd</source>
        <translation>Übung: Kalebasse</translation>
    </message>
    <message>
        <source>Exercise: dumb-bell weight</source>
        <translation>Übung: Hantelgewicht</translation>
    </message>
    <message>
        <source>Exercise: wine glass</source>
        <translation>Übung: Weinglas</translation>
    </message>
    <message>
        <source>Open a prepared exercise</source>
        <translation>Eine fertige Übung öffnen</translation>
    </message>
    <message>
        <source>Handed in by %1</source>
        <translation>Abgegeben von %1</translation>
    </message>
    <message>
        <source>The teacher marks it with the exercise.</source>
        <translation>Die Lehrkraft bewertet sie mit der Übung.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n Schritt</numerusform>
            <numerusform>%n Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>New exercise</source>
        <translation>Neue Übung</translation>
    </message>
    <message>
        <source>Opened %1: exercise “%2”</source>
        <translation>%1 geöffnet: Übung „%2“</translation>
    </message>
    <message>
        <source>Take the model solution</source>
        <translation>Musterlösung übernehmen</translation>
    </message>
    <message>
        <source>The target was not taken</source>
        <translation>Das Ziel wurde nicht übernommen</translation>
    </message>
    <message>
        <source>Take the target</source>
        <translation>Ziel übernehmen</translation>
    </message>
    <message>
        <source>Mark what was handed in</source>
        <translation>Abgaben bewerten</translation>
    </message>
    <message>
        <source>Submissions (%1)</source>
        <translation>Abgaben (%1)</translation>
    </message>
    <message>
        <source>Marking</source>
        <translation>Abgaben werden bewertet</translation>
    </message>
    <message>
        <source>%1 could not be saved</source>
        <translation>%1 konnte nicht gespeichert werden</translation>
    </message>
    <message>
        <source>Save the table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>Table (%1)</source>
        <translation>Tabelle (%1)</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Report (%1)</source>
        <translation>Bericht (%1)</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>E&amp;xercise</source>
        <translation>Üb&amp;ung</translation>
    </message>
    <message>
        <source>Exercise: thread M20</source>
        <translation>Übung: Gewinde M20</translation>
    </message>
    <message>
        <source>Exercise: first shoulder</source>
        <translation>Übung: erster Absatz</translation>
    </message>
    <message>
        <source>The model solution was not taken</source>
        <translation>Die Musterlösung wurde nicht übernommen</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>&amp;Round the target…</source>
        <translation>Ziel &amp;runden …</translation>
    </message>
    <message>
        <source>Give the target round sizes and sharp corners, as a drawing has them</source>
        <translation>Dem Ziel runde Maße und scharfe Ecken geben, wie eine Zeichnung sie hat</translation>
    </message>
    <message>
        <source>Taking the target</source>
        <translation>Ziel wird übernommen</translation>
    </message>
    <message>
        <source>Round the target</source>
        <translation>Ziel runden</translation>
    </message>
    <message>
        <source>Op&amp;en the model solution</source>
        <translation>Musterlösung ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Open a copy of the model solution, to look at it or to go on from it</source>
        <translation>Eine Kopie der Musterlösung öffnen, um sie anzusehen oder von ihr aus weiterzuarbeiten</translation>
    </message>
    <message>
        <source>Model solution taken</source>
        <translation>Musterlösung übernommen</translation>
    </message>
    <message numerus="yes">
        <source>The work in “%1”, as it is after %n step(s) of its history, is the model solution now.</source>
        <translation>
            <numerusform>Die Arbeit in „%1“, wie sie nach %n Schritt ihres Verlaufs ist, ist jetzt die Musterlösung.</numerusform>
            <numerusform>Die Arbeit in „%1“, wie sie nach %n Schritten ihres Verlaufs ist, ist jetzt die Musterlösung.</numerusform>
        </translation>
    </message>
    <message>
        <source>“Open the model solution” shows it. Students do not get it.</source>
        <translation>„Musterlösung öffnen“ zeigt sie. Schüler erhalten sie nicht.</translation>
    </message>
    <message>
        <source>It is in the folder %1.</source>
        <translation>Sie liegt im Ordner %1.</translation>
    </message>
    <message>
        <source>%1, class</source>
        <translation>%1, Klasse</translation>
    </message>
    <message>
        <source>Save the comparison</source>
        <translation>Vergleich speichern</translation>
    </message>
    <message>
        <source>%1, report</source>
        <translation>%1, Bericht</translation>
    </message>
    <message>
        <source>%1, comparison</source>
        <translation>%1, Vergleich</translation>
    </message>
    <message>
        <source>A lesson of about five minutes: the program says what to do, and measures the part.</source>
        <translation>Eine Lektion von etwa fünf Minuten: Das Programm sagt, was zu tun ist, und misst das Teil.</translation>
    </message>
    <message>
        <source>&amp;Import target…</source>
        <translation>Ziel &amp;importieren…</translation>
    </message>
    <message>
        <source>Import a target</source>
        <translation>Ein Ziel importieren</translation>
    </message>
    <message>
        <source>Turned parts (%1)</source>
        <translation>Drehteile (%1)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>%1 was not taken as the target</source>
        <translation>%1 wurde nicht als Ziel übernommen</translation>
    </message>
    <message>
        <source>Import target</source>
        <translation>Ziel importieren</translation>
    </message>
    <message>
        <source>Target read from %1</source>
        <translation>Ziel aus %1 gelesen</translation>
    </message>
    <message>
        <source>%1 is the target now</source>
        <translation>%1 ist jetzt das Ziel</translation>
    </message>
    <message>
        <source>Exercise: burr hole in the skull</source>
        <translation>Übung: Bohrloch im Schädel</translation>
    </message>
    <message>
        <source>Where the target lies</source>
        <translation>Wo das Ziel liegt</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importieren</translation>
    </message>
    <message>
        <source>The exercise was changed meanwhile.</source>
        <translation>Die Übung wurde inzwischen geändert.</translation>
    </message>
    <message>
        <source>Import the target again.</source>
        <translation>Importieren Sie das Ziel noch einmal.</translation>
    </message>
    <message>
        <source>Keep the work that was started from this exercise as its model solution</source>
        <translation>Die Arbeit, die aus dieser Übung begonnen wurde, als Musterlösung behalten</translation>
    </message>
    <message>
        <source>Import the shape that students are to make, from DXF, SVG, STEP, a mesh or a workpiece</source>
        <translation>Die Form, die Schüler herstellen sollen, aus DXF, SVG, STEP, einem Netz oder einem Werkstück importieren</translation>
    </message>
    <message>
        <source>Turn a shoulder step by step; no experience is needed</source>
        <translation>Schritt für Schritt einen Absatz drehen; Vorkenntnisse sind nicht nötig</translation>
    </message>
    <message>
        <source>New exercise: %1</source>
        <translation>Neue Übung: %1</translation>
    </message>
    <message>
        <source>Drill a burr hole</source>
        <translation>Ein Bohrloch im Schädel bohren</translation>
    </message>
    <message>
        <source>Opens an exercise on a skull: drill along the rod, and stop at the breakthrough.</source>
        <translation>Öffnet eine Übung an einem Schädel: Bohren Sie entlang des Stabs, und halten Sie beim Durchbruch an.</translation>
    </message>
    <message>
        <source>Points: %1. Students get a copy without the answers.</source>
        <translation>Punkte: %1. Schüler erhalten eine Fassung ohne die Lösungen.</translation>
    </message>
    <message>
        <source>%1: %2 of %3.</source>
        <translation>%1: %2 von %3.</translation>
    </message>
    <message>
        <source>From %1 to %2 of %3.</source>
        <translation>Von %1 bis %2 von %3.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln file(s) could not be marked; the table says why.</source>
        <translation>
            <numerusform>%Ln Datei konnte nicht bewertet werden; die Tabelle nennt den Grund.</numerusform>
            <numerusform>%Ln Dateien konnten nicht bewertet werden; die Tabelle nennt die Gründe.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln work(s) marked</source>
        <translation>
            <numerusform>%Ln Arbeit bewertet</numerusform>
            <numerusform>%Ln Arbeiten bewertet</numerusform>
        </translation>
    </message>
    <message>
        <source>“Task” shows where it lies in the bar, “Criteria” what is measured.</source>
        <translation>„Aufgabe“ zeigt, wo es in der Stange liegt, „Kriterien“, was gemessen wird.</translation>
    </message>
    <message>
        <source>Model solution</source>
        <translation>Musterlösung</translation>
    </message>
    <message>
        <source>Model solution of %1</source>
        <translation>Musterlösung von %1</translation>
    </message>
    <message>
        <source>Turn the target en&amp;d for end</source>
        <translation>Ziel um&amp;drehen</translation>
    </message>
    <message>
        <source>Make the end at the chuck the free one, whose face is finished</source>
        <translation>Das Ende am Futter zum freien machen, dessen Stirnfläche bearbeitet wird</translation>
    </message>
    <message>
        <source>student&apos;s copy</source>
        <translation>Exemplar für Schüler</translation>
    </message>
    <message>
        <source>Student&apos;s copy</source>
        <translation>Exemplar für Schüler</translation>
    </message>
    <message>
        <source>%1, student&apos;s copy</source>
        <translation>%1, Exemplar für Schüler</translation>
    </message>
    <message>
        <source>The target was not turned</source>
        <translation>Das Ziel wurde nicht umgedreht</translation>
    </message>
    <message>
        <source>Turn the target end for end</source>
        <translation>Ziel umdrehen</translation>
    </message>
    <message>
        <source>The target lies the other way round now</source>
        <translation>Das Ziel liegt jetzt andersherum</translation>
    </message>
    <message>
        <source>“Criteria” are measured at the places where they were: look at them.</source>
        <translation>„Kriterien“ werden an den bisherigen Stellen gemessen: Sehen Sie sie durch.</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Bewerten</translation>
    </message>
    <message>
        <source>Remove from the class</source>
        <translation>Aus der Klasse entfernen</translation>
    </message>
    <message>
        <source>Parts to be drilled (%1)</source>
        <translation>Zu bohrende Teile (%1)</translation>
    </message>
    <message>
        <source>“Task” has the planned path and the forbidden region, “Criteria” what is measured.</source>
        <translation>„Aufgabe“ hat die geplante Bahn und den verbotenen Bereich, „Kriterien“ das, was gemessen wird.</translation>
    </message>
    <message>
        <source>Open an exercise first.</source>
        <translation>Zuerst eine Übung öffnen.</translation>
    </message>
    <message>
        <source>This is a student&apos;s copy.</source>
        <translation>Dies ist eine Schülerfassung.</translation>
    </message>
    <message>
        <source>No work on this exercise is open.</source>
        <translation>Keine Arbeit an dieser Übung ist geöffnet.</translation>
    </message>
    <message>
        <source>The exercise has no solution.</source>
        <translation>Die Übung hat keine Musterlösung.</translation>
    </message>
    <message>
        <source>The exercise has no target.</source>
        <translation>Die Übung hat kein Ziel.</translation>
    </message>
    <message>
        <source>It is for targets of turned parts only.</source>
        <translation>Nur für Ziele von Drehteilen.</translation>
    </message>
    <message>
        <source>The exercise has another target now</source>
        <translation>Die Übung hat jetzt ein anderes Ziel</translation>
    </message>
</context>
<context>
    <name>handwheel::FidelityPanel</name>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
</context>
<context>
    <name>handwheel::FileActions</name>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt verwendet</translation>
    </message>
    <message>
        <source>Open files</source>
        <translation>Dateien öffnen</translation>
    </message>
    <message>
        <source>Save this document</source>
        <translation>Dieses Dokument speichern</translation>
    </message>
    <message>
        <source>Save this document under another name</source>
        <translation>Dieses Dokument unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>Close this document</source>
        <translation>Dieses Dokument schließen</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Save in:</source>
        <translation>Speichern in:</translation>
    </message>
    <message>
        <source>Ne&amp;xt document</source>
        <translation>N&amp;ächstes Dokument</translation>
    </message>
    <message>
        <source>&amp;Previous document</source>
        <translation>&amp;Voriges Dokument</translation>
    </message>
    <message>
        <source>Go to the next open document</source>
        <translation>Zum nächsten offenen Dokument</translation>
    </message>
    <message>
        <source>Go to the previous open document</source>
        <translation>Zum vorigen offenen Dokument</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Save as *%1…</source>
        <translation>Als *%1 speichern…</translation>
    </message>
    <message>
        <source>Open beside %1</source>
        <translation>Neben %1 öffnen</translation>
    </message>
</context>
<context>
    <name>handwheel::FileLoader</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>%1 wird wiederhergestellt</translation>
    </message>
    <message>
        <source>Recovered %1 as it was last autosaved</source>
        <translation>%1 im zuletzt gesicherten Stand wiederhergestellt</translation>
    </message>
    <message>
        <source>%1 could not be opened</source>
        <translation>%1 konnte nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Open what is readable</source>
        <translation>Lesbares öffnen</translation>
    </message>
    <message>
        <source>…and %1 more, listed in the Log.</source>
        <translation>… und %1 weitere, siehe Protokoll.</translation>
    </message>
    <message>
        <source>Not kept by Handwheel: %1.</source>
        <translation>Von Handwheel nicht übernommen: %1.</translation>
    </message>
    <message>
        <source>%1 is damaged</source>
        <translation>%1 ist beschädigt</translation>
    </message>
    <message>
        <source>%1 is opened for reading only</source>
        <translation>%1 ist nur zum Lesen geöffnet</translation>
    </message>
    <message>
        <source>“Save” will ask for a new name, so the original stays as it is.</source>
        <translation>„Speichern“ fragt nach einem neuen Namen, damit das Original bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>Recovering</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Nothing of %1 can be read</source>
        <translation>In %1 lässt sich nichts lesen</translation>
    </message>
    <message>
        <source>%1 is opened as a mesh</source>
        <translation>%1 wird als Netz geöffnet</translation>
    </message>
    <message numerus="yes">
        <source>%Ln more place(s) are damaged</source>
        <translation>
            <numerusform>%Ln weitere Stelle ist beschädigt</numerusform>
            <numerusform>%Ln weitere Stellen sind beschädigt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is incomplete</source>
        <translation>%1 ist unvollständig</translation>
    </message>
    <message>
        <source>Notes on %1</source>
        <translation>Hinweise zu %1</translation>
    </message>
    <message>
        <source>It was written by a newer version of Handwheel; contents that this version does not know are not shown.</source>
        <translation>Sie wurde von einer neueren Version von Handwheel geschrieben; was diese Version nicht kennt, wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>Not all of %1 is kept</source>
        <translation>Von %1 bleibt nicht alles erhalten</translation>
    </message>
    <message>
        <source>A document could not be recovered</source>
        <translation>Ein Dokument konnte nicht wiederhergestellt werden</translation>
    </message>
    <message>
        <source>%1 could not be recovered</source>
        <translation>%1 konnte nicht wiederhergestellt werden</translation>
    </message>
    <message>
        <source>Its autosave is kept, and offered again at the next start.</source>
        <translation>Die automatische Sicherung bleibt erhalten und wird beim nächsten Start wieder angeboten.</translation>
    </message>
    <message>
        <source>The last changes of %1 cannot be read</source>
        <translation>Die letzten Änderungen von %1 lassen sich nicht lesen</translation>
    </message>
    <message>
        <source>It is recovered as it was autosaved before them.</source>
        <translation>Das Dokument wird in dem Stand wiederhergestellt, der vor ihnen automatisch gesichert wurde.</translation>
    </message>
    <message>
        <source>Their file is kept and listed in the Log; it can be discarded at the next start.</source>
        <translation>Ihre Datei bleibt erhalten und ist im Protokoll aufgeführt; sie kann beim nächsten Start verworfen werden.</translation>
    </message>
    <message>
        <source>When it was opened, its file had contents that were damaged or that Handwheel does not keep. They are still in that file.</source>
        <translation>Beim Öffnen enthielt die Datei Inhalte, die beschädigt waren oder die Handwheel nicht behält. Sie stehen noch in dieser Datei.</translation>
    </message>
    <message>
        <source>Save it to keep it.</source>
        <translation>Speichern Sie es, um es zu behalten.</translation>
    </message>
</context>
<context>
    <name>handwheel::FileSaver</name>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Saved %1: %2 bytes, read back and compared</source>
        <translation>%1 gespeichert: %2 Bytes, zurückgelesen und verglichen</translation>
    </message>
    <message>
        <source>%1 could not be saved</source>
        <translation>%1 konnte nicht gespeichert werden</translation>
    </message>
    <message>
        <source>%1 was written</source>
        <translation>%1 wurde geschrieben</translation>
    </message>
    <message>
        <source>The display unit is not in this file.</source>
        <translation>Die Anzeigeeinheit steht nicht in dieser Datei.</translation>
    </message>
    <message>
        <source>Saving %1 was cancelled</source>
        <translation>Speichern von %1 abgebrochen</translation>
    </message>
    <message>
        <source>Save again</source>
        <translation>Erneut speichern</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>%1 contains the state before your last change</source>
        <translation>%1 enthält den Stand vor Ihrer letzten Änderung</translation>
    </message>
    <message>
        <source>%1 does not contain the whole document</source>
        <translation>%1 enthält nicht das ganze Dokument</translation>
    </message>
    <message>
        <source>The document stays open. Save it as *%1, too, to keep all of it.</source>
        <translation>Das Dokument bleibt geöffnet. Speichern Sie es auch als *%1, um alles zu behalten.</translation>
    </message>
    <message>
        <source>The file does not contain the whole document, which is not saved yet.</source>
        <translation>Die Datei enthält nicht das ganze Dokument; das ist noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>Save the document as *%1 to continue with it later.</source>
        <translation>Speichern Sie das Dokument als *%1, um später daran weiterzuarbeiten.</translation>
    </message>
    <message>
        <source>Nothing was written: the file is unchanged.</source>
        <translation>Es wurde nichts geschrieben: Die Datei ist unverändert.</translation>
    </message>
    <message>
        <source>The document is still open, with all its changes.</source>
        <translation>Das Dokument ist offen, mit all seinen Änderungen.</translation>
    </message>
</context>
<context>
    <name>handwheel::FixPreview</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Computing the preview…</source>
        <translation>Vorschau wird berechnet …</translation>
    </message>
    <message>
        <source>Nothing would change: %1.</source>
        <translation>Nichts würde sich ändern: %1.</translation>
    </message>
    <message>
        <source>Nothing would change.</source>
        <translation>Nichts würde sich ändern.</translation>
    </message>
    <message numerus="yes">
        <source>Removes %Ln triangle(s).</source>
        <translation>
            <numerusform>Entfernt %Ln Dreieck.</numerusform>
            <numerusform>Entfernt %Ln Dreiecke.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Adds %Ln triangle(s).</source>
        <translation>
            <numerusform>Fügt %Ln Dreieck hinzu.</numerusform>
            <numerusform>Fügt %Ln Dreiecke hinzu.</numerusform>
        </translation>
    </message>
    <message>
        <source>Replaces %1 by %2.</source>
        <translation>Ersetzt %1 durch %2.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s)</source>
        <translation>
            <numerusform>%Ln Dreieck</numerusform>
            <numerusform>%Ln Dreiecke</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handwheel::FoldButton</name>
    <message>
        <source>Hide the fields of %1</source>
        <translation>Felder von „%1“ ausblenden</translation>
    </message>
    <message>
        <source>Show the fields of %1</source>
        <translation>Felder von „%1“ zeigen</translation>
    </message>
</context>
<context>
    <name>handwheel::ForcePlot</name>
    <message>
        <source>Force of the last seconds</source>
        <translation>Kraft der letzten Sekunden</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>verlangt</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>gesendet</translation>
    </message>
</context>
<context>
    <name>handwheel::FrameTiming</name>
    <message>
        <source>Display frame in use: %1 of %2 ms (%3 %)</source>
        <translation>Bildzeit benutzt: %1 von %2 ms (%3 %)</translation>
    </message>
    <message>
        <source>Predicted in addition, after an edit: %1 ms (%2 %)</source>
        <translation>Vorhergesagt dazu, nach einer Bearbeitung: %1 ms (%2 %)</translation>
    </message>
</context>
<context>
    <name>handwheel::HandwheelDial</name>
    <message>
        <source>Handwheel</source>
        <translation>Handrad</translation>
    </message>
    <message>
        <source>Drag around the centre, or use the wheel or arrow keys: one division (Shift: ten, Ctrl: a tenth); Page Up and Down: one turn; Home or double click: set the dial to zero</source>
        <translation>Um die Mitte ziehen, oder Mausrad oder Pfeiltasten: ein Teilstrich (Umschalt: zehn, Strg: ein Zehntel); Bild auf und Bild ab: eine Umdrehung; Pos1 oder Doppelklick: Skala auf null stellen</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 div</source>
        <translation>%1 Skt</translation>
    </message>
    <message numerus="yes">
        <source>%n turn(s)</source>
        <translation>
            <numerusform>%n Umdrehung</numerusform>
            <numerusform>%n Umdrehungen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handwheel::HapticSession</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Closing %1</source>
        <translation>%1 wird geschlossen</translation>
    </message>
</context>
<context>
    <name>handwheel::HistogramView</name>
    <message>
        <source>Histogram with the range of values</source>
        <translation>Histogramm mit dem Wertebereich</translation>
    </message>
    <message>
        <source>Number of samples of each value (logarithmic). Drag the handles: the values between them are the segment.</source>
        <translation>Anzahl der Abtastwerte je Wert (logarithmisch). Ziehen Sie die Griffe: Die Werte dazwischen sind das Segment.</translation>
    </message>
</context>
<context>
    <name>handwheel::HolePreview</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Comparing methods</source>
        <translation>Methoden werden verglichen</translation>
    </message>
</context>
<context>
    <name>handwheel::HoleSettings</name>
    <message>
        <source>Fill method</source>
        <translation>Füllmethode</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Computing the patch…</source>
        <translation>Füllfläche wird berechnet…</translation>
    </message>
    <message>
        <source>Cannot be filled: %1.</source>
        <translation>Kann nicht gefüllt werden: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln new triangle(s)</source>
        <translation>
            <numerusform>%Ln neues Dreieck</numerusform>
            <numerusform>%Ln neue Dreiecke</numerusform>
        </translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Show the result of each method for this hole</source>
        <translation>Das Ergebnis jeder Methode für dieses Loch zeigen</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Thickness of the sheet&apos;s thin body, which grows to the side opposite to the normals: the triangles of the sheet stay where they are. Less where that would intersect anything; the log says what was reached.</source>
        <translation>Dicke des dünnen Körpers der Fläche, der zur Seite entgegen den Normalen wächst: Die Dreiecke der Fläche bleiben, wo sie sind. Weniger, wo das etwas durchdringen würde; das Protokoll sagt, was erreicht wurde.</translation>
    </message>
    <message>
        <source>Check the patch: %1.</source>
        <translation>Prüfen Sie die Füllfläche: %1.</translation>
    </message>
</context>
<context>
    <name>handwheel::InstructionEditor</name>
    <message>
        <source>Done when these criteria are met:</source>
        <translation>Erledigt, wenn diese Kriterien erfüllt sind:</translation>
    </message>
    <message>
        <source>Hints, shown one after another; double-click to change one:</source>
        <translation>Hinweise, nacheinander gezeigt; Doppelklick ändert einen:</translation>
    </message>
    <message>
        <source>Add a hint</source>
        <translation>Einen Hinweis hinzufügen</translation>
    </message>
    <message>
        <source>Remove the hint</source>
        <translation>Den Hinweis entfernen</translation>
    </message>
</context>
<context>
    <name>handwheel::JobBar</name>
    <message>
        <source>Cancel this job</source>
        <translation>Diesen Vorgang abbrechen</translation>
    </message>
    <message>
        <source>Cancel “%1”</source>
        <translation>„%1“ abbrechen</translation>
    </message>
    <message>
        <source>Show all jobs</source>
        <translation>Alle Vorgänge zeigen</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Vorgänge</translation>
    </message>
    <message>
        <source>+%1</source>
        <translation>+%1</translation>
    </message>
    <message numerus="yes">
        <source>%n more job(s)</source>
        <translation>
            <numerusform>%n weiterer Vorgang</numerusform>
            <numerusform>%n weitere Vorgänge</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (waiting)</source>
        <translation>%1 (wartet)</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>seit %1</translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <translation>%1 – %2</translation>
    </message>
</context>
<context>
    <name>handwheel::KindUi</name>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Measure distances, angles and walls</source>
        <translation>Abstände, Winkel und Wände messen</translation>
    </message>
    <message>
        <source>&amp;Drill</source>
        <translation>&amp;Bohren</translation>
    </message>
    <message>
        <source>Drill into the part, with thrust and torque</source>
        <translation>In das Teil bohren, mit Vorschubkraft und Drehmoment</translation>
    </message>
</context>
<context>
    <name>handwheel::LatheEvents</name>
    <message>
        <source>%1 s: crash, %2 – %3 at R %4, Z %5. %6</source>
        <translation>%1 s: Kollision, %2 – %3 bei R %4, Z %5. %6</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s: %2</translation>
    </message>
    <message>
        <source>Crashes and warnings</source>
        <translation>Kollisionen und Warnungen</translation>
    </message>
    <message>
        <source>Power: the cut needs %1 kW, and the motor has %2 kW; the spindle slows down.</source>
        <translation>Leistung: Der Schnitt braucht %1 kW, und der Motor hat %2 kW; die Spindel wird langsamer.</translation>
    </message>
    <message>
        <source>Torque: the cut needs %1 N·m, and the spindle has %2 N·m; the spindle stalls.</source>
        <translation>Drehmoment: Der Schnitt braucht %1 N·m, und die Spindel hat %2 N·m; die Spindel bleibt stehen.</translation>
    </message>
    <message>
        <source>L/D: the work protrudes by %1 times its diameter; at most %2 times is recommended. Support it.</source>
        <translation>L/D: Das Werkstück steht um das %1-Fache seines Durchmessers vor; empfohlen ist höchstens das %2-Fache. Stützen Sie es ab.</translation>
    </message>
    <message>
        <source>Deflection: the work bends away and is left %1 mm thicker here; the limit is %2 mm.</source>
        <translation>Durchbiegung: Das Werkstück biegt sich weg und bleibt hier %1 mm dicker; die Grenze ist %2 mm.</translation>
    </message>
    <message>
        <source>Chatter: the depth of cut is %1 mm; up to %2 mm is stable at any spindle speed.</source>
        <translation>Rattern: Die Schnitttiefe ist %1 mm; bis %2 mm ist der Schnitt bei jeder Drehzahl stabil.</translation>
    </message>
    <message>
        <source>Rubbing: a chip thickness of %1 mm is too small to be cut; at least %2 mm is needed.</source>
        <translation>Reiben: Eine Spanungsdicke von %1 mm ist zu klein, um geschnitten zu werden; mindestens %2 mm sind nötig.</translation>
    </message>
    <message>
        <source>Collisions with the parts involved, and warnings with the rule that was broken, each with its time. A crash stops the spindle.</source>
        <translation>Kollisionen mit den beteiligten Teilen und Warnungen mit der verletzten Regel, jeweils mit der Zeit. Eine Kollision hält die Spindel an.</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>weniger als %1</translation>
    </message>
    <message>
        <source>Pressing: this tool is laid on the surface and cannot be fed %1 mm into the work; its full force is reached at %2 mm.</source>
        <translation>Drücken: dieses Werkzeug wird auf die Oberfläche gelegt und kann nicht %1 mm ins Werkstück gefahren werden; seine volle Kraft ist bei %2 mm erreicht.</translation>
    </message>
</context>
<context>
    <name>handwheel::LathePanel</name>
    <message>
        <source>Value for touching off, mm</source>
        <translation>Wert beim Ankratzen, mm</translation>
    </message>
    <message>
        <source>Touch off &amp;X</source>
        <translation>&amp;X ankratzen</translation>
    </message>
    <message>
        <source>The read-out shows this value for X here</source>
        <translation>Die Anzeige zeigt hier diesen Wert für X</translation>
    </message>
    <message>
        <source>Touch off &amp;Z</source>
        <translation>&amp;Z ankratzen</translation>
    </message>
    <message>
        <source>The read-out shows this value for Z here</source>
        <translation>Die Anzeige zeigt hier diesen Wert für Z</translation>
    </message>
    <message>
        <source>Direction of the spindle</source>
        <translation>Drehrichtung der Spindel</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Spindel</translation>
    </message>
    <message>
        <source>&amp;Forward</source>
        <translation>&amp;Vorwärts</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Stopp</translation>
    </message>
    <message>
        <source>&amp;Reverse</source>
        <translation>&amp;Rückwärts</translation>
    </message>
    <message>
        <source>Speed, r/min</source>
        <translation>Drehzahl, 1/min</translation>
    </message>
    <message>
        <source>Surface speed, m/min</source>
        <translation>Schnittgeschwindigkeit, m/min</translation>
    </message>
    <message>
        <source>Largest speed, r/min</source>
        <translation>Höchste Drehzahl, 1/min</translation>
    </message>
    <message>
        <source>r/min</source>
        <translation>1/min</translation>
    </message>
    <message>
        <source>m/min, at most</source>
        <translation>m/min, höchstens</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Feed, mm in a turn</source>
        <translation>Vorschub, mm je Umdrehung</translation>
    </message>
    <message>
        <source>mm/rev</source>
        <translation>mm/U</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>To chuck</source>
        <translation>Zum Futter</translation>
    </message>
    <message>
        <source>Away</source>
        <translation>Vom Futter</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Hinein</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Heraus</translation>
    </message>
    <message>
        <source>Pitch of the thread, mm</source>
        <translation>Steigung des Gewindes, mm</translation>
    </message>
    <message>
        <source>&amp;Half-nut</source>
        <translation>Schloss&amp;mutter</translation>
    </message>
    <message>
        <source>Closes the half-nut: the carriage follows the lead screw</source>
        <translation>Schließt die Schlossmutter: Der Bettschlitten folgt der Leitspindel</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Konstant</translation>
    </message>
    <message>
        <source>Constant surface speed: the spindle turns faster the nearer the tool is to the axis</source>
        <translation>Konstante Schnittgeschwindigkeit: Die Spindel dreht umso schneller, je näher das Werkzeug der Achse ist</translation>
    </message>
    <message>
        <source>No automatic feed</source>
        <translation>Kein selbsttätiger Vorschub</translation>
    </message>
    <message>
        <source>Automatic feed of the carriage to the chuck</source>
        <translation>Selbsttätiger Vorschub des Bettschlittens zum Futter</translation>
    </message>
    <message>
        <source>Automatic feed of the carriage away from the chuck</source>
        <translation>Selbsttätiger Vorschub des Bettschlittens vom Futter weg</translation>
    </message>
    <message>
        <source>Automatic feed of the cross slide to the axis</source>
        <translation>Selbsttätiger Vorschub des Planschlittens zur Achse</translation>
    </message>
    <message>
        <source>Automatic feed of the cross slide outward</source>
        <translation>Selbsttätiger Vorschub des Planschlittens nach außen</translation>
    </message>
    <message>
        <source>Thread, pitch</source>
        <translation>Gewinde, Steigung</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>Rapid traverse to the chuck, while held (Alt+←)</source>
        <translation>Eilgang zum Futter, solange gedrückt (Alt+←)</translation>
    </message>
    <message>
        <source>Rapid traverse away from the chuck, while held (Alt+→)</source>
        <translation>Eilgang vom Futter weg, solange gedrückt (Alt+→)</translation>
    </message>
    <message>
        <source>Rapid traverse in, while held (Alt+↑)</source>
        <translation>Eilgang nach innen, solange gedrückt (Alt+↑)</translation>
    </message>
    <message>
        <source>Rapid traverse out, while held (Alt+↓)</source>
        <translation>Eilgang nach außen, solange gedrückt (Alt+↓)</translation>
    </message>
    <message>
        <source>&amp;Left-hand</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>Left-hand thread: while the spindle runs forward the lead screw takes the carriage away from the chuck. It is set while the half-nut is open.</source>
        <translation>Linksgewinde: Bei Vorwärtslauf der Spindel führt die Leitspindel den Bettschlitten vom Futter weg. Wird bei offener Schlossmutter gestellt.</translation>
    </message>
    <message>
        <source>%1 not touched off</source>
        <translation>%1 nicht angekratzt</translation>
    </message>
    <message>
        <source>Turn a little of the bar, measure its diameter, enter it below, and press “Touch off X” before the cross slide moves.</source>
        <translation>Drehen Sie die Stange ein wenig ab, messen Sie ihren Durchmesser, geben Sie ihn unten ein, und drücken Sie „X ankratzen“, bevor sich der Planschlitten bewegt.</translation>
    </message>
    <message>
        <source>Touch the face of the bar with the tool, enter its height below, and press “Touch off Z” before the carriage moves.</source>
        <translation>Berühren Sie die Planfläche der Stange mit dem Werkzeug, geben Sie ihre Höhe unten ein, und drücken Sie „Z ankratzen“, bevor sich der Bettschlitten bewegt.</translation>
    </message>
    <message>
        <source>%1 has no zero yet. %2</source>
        <translation>%1 hat noch keinen Nullpunkt. %2</translation>
    </message>
    <message>
        <source>Diameter at the tip, from the workpiece zero as it was touched off; outward is positive</source>
        <translation>Durchmesser an der Spitze, vom Werkstücknullpunkt aus, wie er angekratzt wurde; nach außen ist positiv</translation>
    </message>
    <message>
        <source>Radius at the tip, from the workpiece zero as it was touched off; outward is positive</source>
        <translation>Radius an der Spitze, vom Werkstücknullpunkt aus, wie er angekratzt wurde; nach außen ist positiv</translation>
    </message>
    <message>
        <source>From the workpiece zero as it was touched off; away from the chuck is positive</source>
        <translation>Vom Werkstücknullpunkt aus, wie er angekratzt wurde; vom Futter weg ist positiv</translation>
    </message>
    <message>
        <source>Touching off</source>
        <translation>Ankratzen</translation>
    </message>
    <message>
        <source>Constant surface speed</source>
        <translation>Konstante Schnittgeschwindigkeit</translation>
    </message>
    <message>
        <source>Thread and rapid traverse</source>
        <translation>Gewinde und Eilgang</translation>
    </message>
    <message>
        <source>Handwheels</source>
        <translation>Handräder</translation>
    </message>
    <message>
        <source>Latest crash or warning</source>
        <translation>Letzte Kollision oder Warnung</translation>
    </message>
</context>
<context>
    <name>handwheel::LatheReadout</name>
    <message>
        <source>Resultant force</source>
        <translation>Zerspankraft</translation>
    </message>
    <message>
        <source>Motor power</source>
        <translation>Motorleistung</translation>
    </message>
    <message>
        <source>%1 of %2 %3</source>
        <translation>%1 von %2 %3</translation>
    </message>
    <message>
        <source>kW</source>
        <translation>kW</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>N·m</source>
        <translation>N·m</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Spindel</translation>
    </message>
    <message>
        <source>%1 r/min</source>
        <translation>%1 1/min</translation>
    </message>
    <message>
        <source>Cutting speed</source>
        <translation>Schnittgeschwindigkeit</translation>
    </message>
    <message>
        <source>%1 m/min</source>
        <translation>%1 m/min</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>%1 mm/rev</source>
        <translation>%1 mm/U</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>Gesetz</translation>
    </message>
    <message>
        <source>Kosilova</source>
        <translation>Kosilova</translation>
    </message>
    <message>
        <source>Law of the cutting force for %1. It is chosen among the settings of speed and accuracy; the material is a property of the workpiece.</source>
        <translation>Gesetz der Schnittkraft für %1. Es wird in den Einstellungen von Geschwindigkeit und Genauigkeit gewählt; der Werkstoff ist eine Eigenschaft des Werkstücks.</translation>
    </message>
    <message>
        <source>Ra here</source>
        <translation>Ra hier</translation>
    </message>
    <message>
        <source>%1 µm</source>
        <translation>%1 µm</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Resultant of cutting, feed and radial force, and the limit of the exercise</source>
        <translation>Resultierende aus Schnitt-, Vorschub- und Passivkraft, und die Grenze der Übung</translation>
    </message>
    <message>
        <source>Power taken from the motor, and its rated power</source>
        <translation>Leistung, die dem Motor entnommen wird, und seine Nennleistung</translation>
    </message>
    <message>
        <source>Torque at the spindle, and the torque available</source>
        <translation>Drehmoment an der Spindel, und das verfügbare Drehmoment</translation>
    </message>
    <message>
        <source>Current spindle speed. A cut beyond the available power or torque slows it down.</source>
        <translation>Jetzige Drehzahl der Spindel. Ein Schnitt über der verfügbaren Leistung oder dem verfügbaren Drehmoment bremst sie.</translation>
    </message>
    <message>
        <source>Surface speed at the middle of the cut</source>
        <translation>Schnittgeschwindigkeit in der Mitte des Schnitts</translation>
    </message>
    <message>
        <source>Depth of cut, measured across the feed direction</source>
        <translation>Schnitttiefe, quer zur Vorschubrichtung gemessen</translation>
    </message>
    <message>
        <source>Feed per revolution of the spindle</source>
        <translation>Vorschub je Umdrehung der Spindel</translation>
    </message>
    <message>
        <source>Roughness of the part at the tool, from feed and nose radius and from later work with file, paper or disk</source>
        <translation>Rauheit des Teils am Werkzeug, aus Vorschub und Eckenradius und aus späterer Bearbeitung mit Feile, Schleifpapier oder Schleifscheibe</translation>
    </message>
    <message>
        <source>The law of the cutting force is not valid for such a cut of %1.</source>
        <translation>Das Gesetz der Schnittkraft gilt nicht für einen solchen Schnitt in %1.</translation>
    </message>
    <message>
        <source>%1 has no data for this material, so Kienzle is used.</source>
        <translation>%1 hat für diesen Werkstoff keine Daten, daher gilt Kienzle.</translation>
    </message>
    <message>
        <source>%1, unverified</source>
        <translation>%1, ungeprüft</translation>
    </message>
    <message>
        <source>Not all numbers of its table were compared with the handbook.</source>
        <translation>Nicht alle Zahlen der Tabelle wurden mit dem Handbuch verglichen.</translation>
    </message>
    <message>
        <source>Power law</source>
        <translation>Potenzgesetz</translation>
    </message>
    <message>
        <source>The cut is outside the range of the network, so the power law fitted to the same data is used.</source>
        <translation>Der Schnitt liegt außerhalb des Bereichs des Netzwerks, daher gilt das Potenzgesetz, das an dieselben Daten angepasst wurde.</translation>
    </message>
    <message>
        <source>%1, outside its range</source>
        <translation>%1, außerhalb seines Bereichs</translation>
    </message>
</context>
<context>
    <name>handwheel::LatheView</name>
    <message>
        <source>Lathe</source>
        <translation>Drehmaschine</translation>
    </message>
    <message>
        <source>The tool was not mounted</source>
        <translation>Das Werkzeug wurde nicht eingespannt</translation>
    </message>
    <message>
        <source>Workpiece zero</source>
        <translation>Werkstücknullpunkt</translation>
    </message>
    <message>
        <source>The tool was moved</source>
        <translation>Das Werkzeug wurde bewegt</translation>
    </message>
    <message>
        <source>The spindle turns as before.</source>
        <translation>Die Spindel dreht sich wie zuvor.</translation>
    </message>
    <message>
        <source>The tool does not touch the work</source>
        <translation>Das Werkzeug berührt das Werkstück nicht</translation>
    </message>
    <message>
        <source>Its tip is %1 mm from the nearest surface, measured on the radius. X was not touched off.</source>
        <translation>Seine Spitze ist %1 mm von der nächsten Oberfläche entfernt, im Radius gemessen. X wurde nicht angekratzt.</translation>
    </message>
    <message>
        <source>Its tip is %1 mm from the nearest face, measured along Z. Z was not touched off.</source>
        <translation>Seine Spitze ist %1 mm von der nächsten Planfläche entfernt, entlang Z gemessen. Z wurde nicht angekratzt.</translation>
    </message>
    <message>
        <source>Turn a little of the bar, and touch off before the cross slide moves.</source>
        <translation>Drehen Sie die Stange ein wenig ab, und kratzen Sie an, bevor sich der Planschlitten bewegt.</translation>
    </message>
    <message>
        <source>Touch or turn a face, and touch off before the carriage moves.</source>
        <translation>Berühren oder drehen Sie eine Planfläche, und kratzen Sie an, bevor sich der Bettschlitten bewegt.</translation>
    </message>
    <message>
        <source>Touch off anyway</source>
        <translation>Trotzdem ankratzen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The restored material is where the tool was, so the tool was moved out of it.</source>
        <translation>Das wiederhergestellte Material ist dort, wo das Werkzeug war; daher wurde das Werkzeug herausgefahren.</translation>
    </message>
    <message>
        <source>The spindle stands still.</source>
        <translation>Die Spindel steht still.</translation>
    </message>
    <message>
        <source>The spindle was stopped</source>
        <translation>Die Spindel wurde angehalten</translation>
    </message>
    <message>
        <source>The lathe of %1 stands still while another document is shown.</source>
        <translation>Die Drehmaschine von %1 steht still, solange ein anderes Dokument gezeigt wird.</translation>
    </message>
    <message>
        <source>Its slides stay where they are, and its handwheels count on.</source>
        <translation>Die Schlitten bleiben, wo sie sind, und die Handräder zählen weiter.</translation>
    </message>
    <message>
        <source>The work has another size there</source>
        <translation>Das Werkstück hat dort ein anderes Maß</translation>
    </message>
    <message>
        <source>%1 %2 mm was entered; where the tool touches, the work has %1 %3 mm. X was not touched off.</source>
        <translation>Eingegeben wurden %1 %2 mm; wo das Werkzeug berührt, hat das Werkstück %1 %3 mm. X wurde nicht angekratzt.</translation>
    </message>
    <message>
        <source>Measure again, and correct the number, or take it as it is. Undo takes it back.</source>
        <translation>Messen Sie noch einmal, und berichtigen Sie die Zahl, oder übernehmen Sie sie so. Rückgängig nimmt sie zurück.</translation>
    </message>
    <message>
        <source>Take %1</source>
        <translation>%1 übernehmen</translation>
    </message>
    <message>
        <source>Keep the read-out</source>
        <translation>Anzeige beibehalten</translation>
    </message>
    <message>
        <source>The face is at another Z</source>
        <translation>Die Planfläche liegt bei einem anderen Z</translation>
    </message>
    <message>
        <source>Z %1 mm was entered; from the zero of the work, the face that the tool touches is at Z %2 mm. Z was not touched off.</source>
        <translation>Z %1 mm wurde eingegeben; vom Nullpunkt des Werkstücks aus liegt die Planfläche, die das Werkzeug berührt, bei Z %2 mm. Z wurde nicht angekratzt.</translation>
    </message>
</context>
<context>
    <name>handwheel::LatheWheels</name>
    <message>
        <source>Carriage</source>
        <translation>Bettschlitten</translation>
    </message>
    <message>
        <source>Clockwise: away from the chuck. In the view: ← and →</source>
        <translation>Im Uhrzeigersinn: vom Futter weg. In der Ansicht: ← und →</translation>
    </message>
    <message>
        <source>Cross slide</source>
        <translation>Planschlitten</translation>
    </message>
    <message>
        <source>Compound slide</source>
        <translation>Oberschlitten</translation>
    </message>
    <message>
        <source>Clockwise: forward. In the view: Page Up and Page Down</source>
        <translation>Im Uhrzeigersinn: vorwärts. In der Ansicht: Bild auf und Bild ab</translation>
    </message>
    <message>
        <source>Tailstock quill</source>
        <translation>Reitstockpinole</translation>
    </message>
    <message>
        <source>Clockwise: out, to the work</source>
        <translation>Im Uhrzeigersinn: hinaus, zum Werkstück</translation>
    </message>
    <message>
        <source>Clockwise: in, to the axis; counts as the read-out does, on the diameter (⌀) or the radius (R). In the view: ↑ and ↓</source>
        <translation>Im Uhrzeigersinn: hinein, zur Achse; zählt wie die Anzeige, im Durchmesser (⌀) oder im Radius (R). In der Ansicht: ↑ und ↓</translation>
    </message>
    <message>
        <source>Δ: travel since the ring was at zero; it is not a size of the part</source>
        <translation>Δ: Weg, seit der Ring auf null stand; kein Maß des Teils</translation>
    </message>
</context>
<context>
    <name>handwheel::LessonPanel</name>
    <message>
        <source>Show a hint</source>
        <translation>Einen Hinweis zeigen</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Erledigt</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>%1, open</source>
        <translation>%1, offen</translation>
    </message>
    <message>
        <source>%1, done</source>
        <translation>%1, erledigt</translation>
    </message>
    <message>
        <source>%1, failed</source>
        <translation>%1, nicht bestanden</translation>
    </message>
    <message>
        <source>No steps</source>
        <translation>Keine Schritte</translation>
    </message>
    <message>
        <source>%1 of %2 steps</source>
        <translation>%1 von %2 Schritten</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>The time is over</source>
        <translation>Die Zeit ist um</translation>
    </message>
    <message>
        <source>Show another hint</source>
        <translation>Noch einen Hinweis zeigen</translation>
    </message>
    <message>
        <source>Time since the beginning, in minutes and seconds</source>
        <translation>Zeit seit dem Beginn, in Minuten und Sekunden</translation>
    </message>
</context>
<context>
    <name>handwheel::LivePage</name>
    <message>
        <source>Force on</source>
        <translation>Kraft ein</translation>
    </message>
    <message>
        <source>Test the force</source>
        <translation>Kraft prüfen</translation>
    </message>
    <message>
        <source>This device has no motors: the force is only shown.</source>
        <translation>Dieses Gerät hat keine Motoren: Die Kraft wird nur angezeigt.</translation>
    </message>
    <message>
        <source>The device pushes gently along each axis. Hold the grip.</source>
        <translation>Das Gerät drückt sanft entlang jeder Achse. Halten Sie den Griff.</translation>
    </message>
    <message>
        <source>Let the device apply forces; without this it only points</source>
        <translation>Das Gerät darf Kräfte ausüben; ohne dies zeigt es nur</translation>
    </message>
    <message>
        <source>Torque that is sent to the device, of the largest that it has</source>
        <translation>Drehmoment, das an das Gerät geht, vom größten, das es hat</translation>
    </message>
    <message>
        <source>Torque: %1 of %2 N·mm</source>
        <translation>Drehmoment: %1 von %2 N·mm</translation>
    </message>
</context>
<context>
    <name>handwheel::LogModel</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>Command line</source>
        <translation>Befehlszeile</translation>
    </message>
</context>
<context>
    <name>handwheel::LogPanel</name>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
</context>
<context>
    <name>handwheel::LongTextRow</name>
    <message>
        <source>Ctrl+Return, or leaving the field, takes the text; Esc gives it back as it was.</source>
        <translation>Strg+Eingabetaste oder das Verlassen des Felds übernimmt den Text; Esc stellt ihn wieder her, wie er war.</translation>
    </message>
</context>
<context>
    <name>handwheel::MainWindow</name>
    <message>
        <source>&amp;Show the list</source>
        <translation>Liste &amp;zeigen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Show the whole model and its panel</source>
        <translation>Ganzes Modell und sein Feld zeigen</translation>
    </message>
    <message>
        <source>%1[*] — Handwheel</source>
        <translation>%1[*] – Handwheel</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>einpassen</translation>
    </message>
    <message>
        <source>open a file</source>
        <translation>Datei öffnen</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Ablegen</translation>
    </message>
    <message>
        <source>files anywhere</source>
        <translation>Dateien irgendwo</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>The 3D view cannot be drawn</source>
        <translation>Die 3D-Ansicht kann nicht gezeichnet werden</translation>
    </message>
    <message>
        <source>Files can still be repaired and saved.</source>
        <translation>Dateien lassen sich trotzdem reparieren und speichern.</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Documents</source>
        <translation>Dokumente</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
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
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>&amp;About Handwheel</source>
        <translation>Ü&amp;ber Handwheel</translation>
    </message>
    <message>
        <source>Quick actions</source>
        <translation>Schnellzugriff</translation>
    </message>
    <message>
        <source>Actions of the document</source>
        <translation>Aktionen des Dokuments</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No document is open.</source>
        <translation>Kein Dokument ist geöffnet.</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>The document is as it was before.</source>
        <translation>Das Dokument ist wie zuvor.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Lengths are shown in %1: the display unit of the document, among its properties</source>
        <translation>Längen werden in %1 angezeigt: der Anzeigeeinheit des Dokuments, unter seinen Eigenschaften</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Befehle suchen</translation>
    </message>
    <message>
        <source>Fidelity</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Keyboard shortcuts, mouse, units, language, autosave</source>
        <translation>Tastenkürzel, Maus, Einheiten, Sprache, automatisches Sichern</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>&amp;Gerät</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>&amp;Measure this machine</source>
        <translation>Diesen Rechner &amp;messen</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>The tool failed and was closed</source>
        <translation>Das Werkzeug ist gescheitert und wurde geschlossen</translation>
    </message>
    <message>
        <source>Measure how fast each setting of the panel “Fidelity” is on this machine: about half a minute</source>
        <translation>Messen, wie schnell jede Einstellung des Felds „Genauigkeit“ auf diesem Rechner ist: etwa eine halbe Minute</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Sa&amp;mples and exercises</source>
        <translation>Beis&amp;piele und Übungen</translation>
    </message>
    <message>
        <source>As created</source>
        <translation>Wie erstellt</translation>
    </message>
    <message>
        <source>History begins when the file was opened</source>
        <translation>Der Verlauf beginnt beim Öffnen der Datei</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Wie in der Datei</translation>
    </message>
    <message>
        <source>“%1” was cancelled</source>
        <translation>„%1“ wurde abgebrochen</translation>
    </message>
    <message>
        <source>%1 is as it was.</source>
        <translation>%1 ist unverändert.</translation>
    </message>
</context>
<context>
    <name>handwheel::MappingForm</name>
    <message>
        <source>Button %1</source>
        <translation>Taste %1</translation>
    </message>
</context>
<context>
    <name>handwheel::MeshDocument</name>
    <message>
        <source>Keep open</source>
        <translation>Offen lassen</translation>
    </message>
    <message>
        <source>No longer keep open</source>
        <translation>Nicht mehr offen lassen</translation>
    </message>
    <message>
        <source>Triangles reversed on opening: %1</source>
        <translation>Beim Öffnen umgekehrte Dreiecke: %1</translation>
    </message>
</context>
<context>
    <name>handwheel::MeshHapticsProvider</name>
    <message>
        <source>Preparing to touch</source>
        <translation>Berührung wird vorbereitet</translation>
    </message>
    <message>
        <source>Preparing to snap</source>
        <translation>Fangen wird vorbereitet</translation>
    </message>
</context>
<context>
    <name>handwheel::MeshUi</name>
    <message>
        <source>Defects</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>&amp;Repair</source>
        <translation>&amp;Reparatur</translation>
    </message>
    <message>
        <source>&amp;Holes</source>
        <translation>&amp;Löcher</translation>
    </message>
    <message>
        <source>&amp;Select faces</source>
        <translation>&amp;Flächen auswählen</translation>
    </message>
    <message>
        <source>Choose a hole, look at its patch, fill it</source>
        <translation>Ein Loch wählen, die Füllfläche ansehen, füllen</translation>
    </message>
    <message>
        <source>Select faces by click, brush, lasso, connection or angle</source>
        <translation>Flächen wählen durch Klick, Pinsel, Lasso, Zusammenhang oder Winkel</translation>
    </message>
    <message>
        <source>&amp;Make a face</source>
        <translation>Fläche er&amp;zeugen</translation>
    </message>
    <message>
        <source>&amp;Reduce triangles</source>
        <translation>&amp;Dreiecke reduzieren</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>&amp;Platzieren</translation>
    </message>
    <message>
        <source>Sc&amp;ulpt</source>
        <translation>Modell&amp;ieren</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Open the &amp;sample scan</source>
        <translation>Beisp&amp;iel-Scan öffnen</translation>
    </message>
    <message>
        <source>Open the sample scan</source>
        <translation>Beispiel-Scan öffnen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s)</source>
        <translation>
            <numerusform>%Ln Dreieck</numerusform>
            <numerusform>%Ln Dreiecke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s)</source>
        <translation>
            <numerusform>%n Dreieck</numerusform>
            <numerusform>%n Dreiecke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s)</source>
        <translation>
            <numerusform>%n Loch</numerusform>
            <numerusform>%n Löcher</numerusform>
        </translation>
    </message>
    <message>
        <source>Opened %1: %2</source>
        <translation>%1 geöffnet: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n reversed</source>
        <translation>
            <numerusform>%n umgekehrt</numerusform>
            <numerusform>%n umgekehrt</numerusform>
        </translation>
    </message>
    <message>
        <source>Repair a sample scan</source>
        <translation>Beispielscan reparieren</translation>
    </message>
    <message>
        <source>Hole &amp;boundaries</source>
        <translation>Loc&amp;hränder</translation>
    </message>
    <message>
        <source>Move, join and bridge boundary vertices; smooth a boundary; remove islands and peninsulas</source>
        <translation>Randeckpunkte verschieben, verbinden und überbrücken; einen Rand glätten; Inseln und Halbinseln entfernen</translation>
    </message>
    <message>
        <source>Make a face from three vertices of open edges</source>
        <translation>Eine Fläche aus drei Eckpunkten offener Kanten erzeugen</translation>
    </message>
    <message>
        <source>Reduce the number of triangles while staying close to the surface</source>
        <translation>Die Zahl der Dreiecke verringern und nah an der Oberfläche bleiben</translation>
    </message>
    <message>
        <source>Move, rotate and scale by numbers, or place on a flat face, along the axes or at the origin</source>
        <translation>Mit Zahlen verschieben, drehen und skalieren oder auf eine ebene Fläche, entlang der Achsen oder in den Ursprung setzen</translation>
    </message>
    <message>
        <source>Drag, smooth, inflate and flatten a surface; subdivide a patch and sculpt it at any of its levels</source>
        <translation>Eine Oberfläche ziehen, glätten, aufblähen und ebnen; eine Füllfläche unterteilen und auf jeder ihrer Stufen modellieren</translation>
    </message>
    <message>
        <source>Su&amp;bdivide</source>
        <translation>&amp;Unterteilen</translation>
    </message>
    <message>
        <source>Refine the whole mesh by a subdivision scheme, including open edges</source>
        <translation>Das ganze Netz nach einem Unterteilungsschema verfeinern, auch an offenen Kanten</translation>
    </message>
    <message>
        <source>Opens a sample scan with holes. Press N to see the first one, then Enter to close it.</source>
        <translation>Öffnet einen Beispiel-Scan mit Löchern. N zeigt das erste, die Eingabetaste schließt es.</translation>
    </message>
    <message>
        <source>Repair by &amp;volume</source>
        <translation>&amp;Volumetrisch reparieren</translation>
    </message>
    <message>
        <source>Replace everything by the surface of the volume that is enclosed: closed and free of self-intersections, without details smaller than a voxel</source>
        <translation>Alles durch die Oberfläche des eingeschlossenen Volumens ersetzen: geschlossen und frei von Selbstdurchdringungen, ohne Einzelheiten, die kleiner als ein Voxel sind</translation>
    </message>
</context>
<context>
    <name>handwheel::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n weitere</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the next message</source>
        <translation>Die nächste Meldung zeigen</translation>
    </message>
</context>
<context>
    <name>handwheel::MethodTable</name>
    <message>
        <source>Methods side by side</source>
        <translation>Methoden nebeneinander</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>mm²</source>
        <translation>mm²</translation>
    </message>
    <message>
        <source>Area of the patch</source>
        <translation>Flächeninhalt der Füllfläche</translation>
    </message>
    <message>
        <source>The sharpest edge, that of the hole included</source>
        <translation>Die schärfste Kante, den Lochrand eingeschlossen</translation>
    </message>
    <message>
        <source>%1 It took %2 ms.</source>
        <translation>%1 Es dauerte %2 ms.</translation>
    </message>
    <message>
        <source>Root mean square over all edges: %1</source>
        <translation>Quadratisches Mittel über alle Kanten: %1</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Knick</translation>
    </message>
    <message>
        <source>Triangles of the patch</source>
        <translation>Dreiecke der Füllfläche</translation>
    </message>
</context>
<context>
    <name>handwheel::NumberField</name>
    <message>
        <source>in %1</source>
        <translation>in %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>Must be at least %1.</source>
        <translation>Muss mindestens %1 sein.</translation>
    </message>
    <message>
        <source>Must be at most %1.</source>
        <translation>Darf höchstens %1 sein.</translation>
    </message>
</context>
<context>
    <name>handwheel::PairsDialog</name>
    <message>
        <source>Pairs that may touch</source>
        <translation>Paare, die sich berühren dürfen</translation>
    </message>
    <message>
        <source>Nothing meets where the robot is, nor on the selected path.</source>
        <translation>Weder wo der Roboter ist, noch auf der gewählten Bahn trifft sich etwas.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>Checked pairs may touch: nothing is proven about them. Neighbouring links may touch anyway.</source>
        <translation>Angehakte Paare dürfen sich berühren: Über sie wird nichts bewiesen. Benachbarte Glieder dürfen sich ohnehin berühren.</translation>
    </message>
</context>
<context>
    <name>handwheel::PartSurfaces</name>
    <message>
        <source>Finding the edges of %1</source>
        <translation>Kanten von %1 werden gesucht</translation>
    </message>
</context>
<context>
    <name>handwheel::PathChecks</name>
    <message>
        <source>Verifying %1</source>
        <translation>%1 wird geprüft</translation>
    </message>
    <message>
        <source>Comparing the cell with what was verified</source>
        <translation>Zelle wird mit dem Geprüften verglichen</translation>
    </message>
</context>
<context>
    <name>handwheel::PathDock</name>
    <message>
        <source>Pl&amp;ay the path</source>
        <translation>Bahn &amp;abspielen</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>The path is being verified.</source>
        <translation>Die Bahn wird geprüft.</translation>
    </message>
    <message>
        <source>Select a path in the panel, or plan one, to play it here.</source>
        <translation>Wählen oder planen Sie eine Bahn, um sie hier abzuspielen.</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Margin to the limits</source>
        <translation>Abstand zu den Grenzen</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Manipulability</source>
        <translation>Manipulierbarkeit</translation>
    </message>
    <message>
        <source>Collision: %1 with %2</source>
        <translation>Kollision: %1 mit %2</translation>
    </message>
    <message>
        <source>; collision: %1 with %2</source>
        <translation>; Kollision: %1 mit %2</translation>
    </message>
    <message>
        <source>Plays the path on a time line, with its clearance and its collisions</source>
        <translation>Spielt die Bahn auf einer Zeitleiste ab, mit Abstand und Kollisionen</translation>
    </message>
    <message>
        <source>Clearance to keep</source>
        <translation>Einzuhaltender Abstand</translation>
    </message>
    <message>
        <source>The straight line to the second place cannot be begun.</source>
        <translation>Die gerade Strecke zur zweiten Stelle kann nicht begonnen werden.</translation>
    </message>
    <message>
        <source>Too near: %1 to %2</source>
        <translation>Zu nah: %1 an %2</translation>
    </message>
    <message>
        <source>X %1  Y %2  Z %3 mm</source>
        <translation>X %1  Y %2  Z %3 mm</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>To place %1 of %2: %3</source>
        <translation>Zu Punkt %1 von %2: %3</translation>
    </message>
</context>
<context>
    <name>handwheel::PathGuides</name>
    <message>
        <source>Finding the curve along %1</source>
        <translation>Kurve entlang %1 wird ermittelt</translation>
    </message>
</context>
<context>
    <name>handwheel::PlanDialog</name>
    <message>
        <source>Plan a path</source>
        <translation>Bahn planen</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Planen</translation>
    </message>
    <message>
        <source>The path begins where it ends: choose another end.</source>
        <translation>Die Bahn beginnt, wo sie endet: Wählen Sie ein anderes Ende.</translation>
    </message>
    <message>
        <source>The path is proven free of collisions everywhere between its places.</source>
        <translation>Die Bahn ist überall zwischen ihren Punkten bewiesen kollisionsfrei.</translation>
    </message>
    <message>
        <source>Critical configurations and targets on the way, from the top down (drag to reorder):</source>
        <translation>Kritische Stellungen und Ziele auf dem Weg, von oben nach unten (zum Umordnen ziehen):</translation>
    </message>
    <message>
        <source>The robot has simplified shapes, smaller than its own in places: keep a clearance, or use its maker&apos;s shapes by a URDF.</source>
        <translation>Der Roboter hat vereinfachte Formen, stellenweise kleiner als seine eigenen: einen Abstand halten oder die Formen des Herstellers aus einer URDF verwenden.</translation>
    </message>
</context>
<context>
    <name>handwheel::PlanTree</name>
    <message>
        <source>Configurations</source>
        <translation>Stellungen</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>gerade Linie</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: critical</source>
        <translation>%1: kritisch</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>planned for</source>
        <translation>für ihn wird geplant</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>Configurations, paths, targets and frames</source>
        <translation>Stellungen, Bahnen, Ziele und Bezugssysteme</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bezugssysteme</translation>
    </message>
</context>
<context>
    <name>handwheel::PlotWidget</name>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2, %3</translation>
    </message>
</context>
<context>
    <name>handwheel::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Autosave</source>
        <translation>Automatisches Sichern</translation>
    </message>
    <message>
        <source>Mouse navigation</source>
        <translation>Mausnavigation</translation>
    </message>
    <message>
        <source>Move the view as in</source>
        <translation>Ansicht bewegen wie in</translation>
    </message>
    <message>
        <source>Length unit</source>
        <translation>Längeneinheit</translation>
    </message>
    <message>
        <source>Millimetres (mm)</source>
        <translation>Millimeter (mm)</translation>
    </message>
    <message>
        <source>Centimetres (cm)</source>
        <translation>Zentimeter (cm)</translation>
    </message>
    <message>
        <source>Metres (m)</source>
        <translation>Meter (m)</translation>
    </message>
    <message>
        <source>Inches (in)</source>
        <translation>Zoll (in)</translation>
    </message>
    <message>
        <source>Lengths of new documents</source>
        <translation>Längen neuer Dokumente</translation>
    </message>
    <message>
        <source>Each document can show another unit. Every field takes all units: “1 in + 2 mm”.</source>
        <translation>Jedes Dokument kann eine andere Einheit zeigen. Jedes Feld nimmt alle Einheiten an: „1 in + 2 mm“.</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Save a recovery copy while working</source>
        <translation>Während der Arbeit eine Sicherungskopie anlegen</translation>
    </message>
    <message>
        <source>Seconds between recovery copies</source>
        <translation>Sekunden zwischen Sicherungskopien</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>The copy is kept beside your files, never in their place; after a crash it is offered to you.</source>
        <translation>Die Kopie liegt neben Ihren Dateien und ersetzt sie nie; nach einem Absturz wird sie Ihnen angeboten.</translation>
    </message>
    <message>
        <source>A space mouse moves the view</source>
        <translation>Eine Space-Mouse bewegt die Ansicht</translation>
    </message>
    <message>
        <source>Speed of the space mouse</source>
        <translation>Geschwindigkeit der Space-Mouse</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Its speed</source>
        <translation>Ihre Geschwindigkeit</translation>
    </message>
    <message>
        <source>Its axes are set in the panel “Device” while it is the chosen device.</source>
        <translation>Seine Achsen werden im Feld „Gerät“ eingestellt, während es das gewählte Gerät ist.</translation>
    </message>
    <message>
        <source>Takes effect at the next start.</source>
        <translation>Wird beim nächsten Start wirksam.</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Play the sound of machines</source>
        <translation>Maschinengeräusche wiedergeben</translation>
    </message>
    <message>
        <source>Volume of machines</source>
        <translation>Lautstärke der Maschinen</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>Spindle and cut, from speed, feed, force and wear. Louder means more force; a deep tone means chatter.</source>
        <translation>Spindel und Schnitt, aus Drehzahl, Vorschub, Kraft und Verschleiß. Lauter heißt mehr Kraft; ein tiefer Ton heißt Rattern.</translation>
    </message>
    <message>
        <source>At the latest after</source>
        <translation>Spätestens nach</translation>
    </message>
    <message>
        <source>It is made within a second after each edit, less often where that takes long.</source>
        <translation>Sie wird innerhalb einer Sekunde nach jeder Änderung angelegt, seltener, wo das lange dauert.</translation>
    </message>
</context>
<context>
    <name>handwheel::ProgramDock</name>
    <message>
        <source>&amp;Program</source>
        <translation>&amp;Programm</translation>
    </message>
    <message>
        <source>Run lathe programs on the part, and write them</source>
        <translation>Drehprogramme am Teil ausführen und schreiben</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Program zero</source>
        <translation>Programmnullpunkt</translation>
    </message>
</context>
<context>
    <name>handwheel::ProgramEditor</name>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
</context>
<context>
    <name>handwheel::ProgramPanel</name>
    <message>
        <source>Errors and collisions</source>
        <translation>Fehler und Kollisionen</translation>
    </message>
    <message>
        <source>A click jumps to the line, and shows the place of a collision.</source>
        <translation>Ein Klick springt zur Zeile und zeigt die Stelle einer Kollision.</translation>
    </message>
    <message>
        <source>Open a program, drop one here, or write one.</source>
        <translation>Öffnen Sie ein Programm, ziehen Sie eines hierher, oder schreiben Sie eines.</translation>
    </message>
    <message>
        <source>Run the program first.</source>
        <translation>Lassen Sie zuerst das Programm laufen.</translation>
    </message>
    <message>
        <source>Make</source>
        <translation>Erstellen</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>The control for which the program is written. It is recognised when a program is opened.</source>
        <translation>Die Steuerung, für die das Programm geschrieben ist. Sie wird beim Öffnen eines Programms erkannt.</translation>
    </message>
    <message>
        <source>LinuxCNC</source>
        <translation>LinuxCNC</translation>
    </message>
    <message>
        <source>Fanuc, system A</source>
        <translation>Fanuc, System A</translation>
    </message>
    <message>
        <source>Nose radius of the tools</source>
        <translation>Eckenradius der Werkzeuge</translation>
    </message>
    <message>
        <source>Nose radius of all tools; 0: the tools are points</source>
        <translation>Eckenradius aller Werkzeuge; 0: die Werkzeuge sind Punkte</translation>
    </message>
    <message>
        <source>Nose</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>Aus&amp;führen</translation>
    </message>
    <message>
        <source>Simulate the program on the part; the document stays as it is</source>
        <translation>Das Programm am Teil simulieren; das Dokument bleibt, wie es ist</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop this run</source>
        <translation>Diesen Lauf anhalten</translation>
    </message>
    <message>
        <source>&amp;Cut the work</source>
        <translation>Werkstück &amp;zerspanen</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>Fortschritt des Laufs</translation>
    </message>
    <message>
        <source>Line %1: </source>
        <translation>Zeile %1: </translation>
    </message>
    <message>
        <source>Line %1, column %2: </source>
        <translation>Zeile %1, Spalte %2: </translation>
    </message>
    <message>
        <source>&amp;Tools…</source>
        <translation>&amp;Werkzeuge…</translation>
    </message>
    <message>
        <source>&amp;Tools (%1)…</source>
        <translation>&amp;Werkzeuge (%1)…</translation>
    </message>
    <message>
        <source>Generate a program from the recorded passes or for the target</source>
        <translation>Ein Programm erzeugen: aus den aufgezeichneten Schnitten oder für das Ziel</translation>
    </message>
    <message>
        <source>Tool table of the program: nose radii, holders and offsets</source>
        <translation>Werkzeugtabelle des Programms: Eckenradien, Halter und Korrekturen</translation>
    </message>
    <message>
        <source>Tool post</source>
        <translation>Werkzeugträger</translation>
    </message>
    <message>
        <source>Tool post of the machine, and the side that the inserts face: they decide between M3 and M4. X+ points to the post; seen from above, G2, G3, G41 and G42 appear reversed if it is in front.</source>
        <translation>Werkzeugträger der Maschine und die Seite, zu der die Schneidplatten zeigen: danach richtet sich, ob M3 oder M4 richtig ist. X+ zeigt zum Träger; von oben gesehen erscheinen G2, G3, G41 und G42 umgekehrt, wenn er vorne steht.</translation>
    </message>
    <message>
        <source>Behind, insert down (M3)</source>
        <translation>Hinten, Platte unten (M3)</translation>
    </message>
    <message>
        <source>Behind, insert up (M4)</source>
        <translation>Hinten, Platte oben (M4)</translation>
    </message>
    <message>
        <source>In front, insert down (M4)</source>
        <translation>Vorne, Platte unten (M4)</translation>
    </message>
    <message>
        <source>In front, insert up (M3)</source>
        <translation>Vorne, Platte oben (M3)</translation>
    </message>
</context>
<context>
    <name>handwheel::ProgramPlayer</name>
    <message>
        <source>One line back</source>
        <translation>Eine Zeile zurück</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>One line on</source>
        <translation>Eine Zeile weiter</translation>
    </message>
    <message>
        <source>Time in the program</source>
        <translation>Zeit im Programm</translation>
    </message>
    <message>
        <source>Speed of playing</source>
        <translation>Abspielgeschwindigkeit</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Speed relative to that of the machine</source>
        <translation>Geschwindigkeit im Verhältnis zu der der Maschine</translation>
    </message>
</context>
<context>
    <name>handwheel::ProgramSearchBar</name>
    <message>
        <source>Find in the program</source>
        <translation>Im Programm suchen</translation>
    </message>
    <message>
        <source>Previous (Shift+F3)</source>
        <translation>Voriger Treffer (Umschalt+F3)</translation>
    </message>
    <message>
        <source>Next (F3)</source>
        <translation>Nächster Treffer (F3)</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Schließen (Esc)</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
</context>
<context>
    <name>handwheel::ProgramSession</name>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1: %2. %3</translation>
    </message>
    <message>
        <source>&amp;Open program…</source>
        <translation>Programm ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a program: .ngc, .nc, .tap or .txt</source>
        <translation>Ein Programm öffnen: .ngc, .nc, .tap oder .txt</translation>
    </message>
    <message>
        <source>&amp;Save program</source>
        <translation>Programm &amp;speichern</translation>
    </message>
    <message>
        <source>Save the program in its file (Ctrl+S in the text)</source>
        <translation>Das Programm in seiner Datei speichern (Strg+S im Text)</translation>
    </message>
    <message>
        <source>Save program &amp;as…</source>
        <translation>Programm speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save the program under another name</source>
        <translation>Das Programm unter einem anderen Namen speichern</translation>
    </message>
    <message>
        <source>Program from &amp;passes…</source>
        <translation>Programm aus Schnitte&amp;n…</translation>
    </message>
    <message>
        <source>Write the passes that cut this part as a program</source>
        <translation>Die Schnitte, aus denen dieses Teil entstand, als Programm schreiben</translation>
    </message>
    <message>
        <source>&amp;Rough and finish…</source>
        <translation>S&amp;chruppen und schlichten…</translation>
    </message>
    <message>
        <source>Write a program that makes the target from the part. It is simulated before it is shown.</source>
        <translation>Ein Programm schreiben, das aus dem Teil das Ziel macht. Es wird simuliert, bevor es gezeigt wird.</translation>
    </message>
    <message>
        <source>Untitled program</source>
        <translation>Unbenanntes Programm</translation>
    </message>
    <message>
        <source>Checking the program</source>
        <translation>Programm wird geprüft</translation>
    </message>
    <message numerus="yes">
        <source>%n error(s): the program does not run as it is.</source>
        <translation>
            <numerusform>%n Fehler: Das Programm läuft so nicht.</numerusform>
            <numerusform>%n Fehler: Das Programm läuft so nicht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Open a program</source>
        <translation>Ein Programm öffnen</translation>
    </message>
    <message>
        <source>Programs (%1);;All files (*)</source>
        <translation>Programme (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>%1 could not be opened</source>
        <translation>%1 konnte nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Program read from %1</source>
        <translation>Programm aus %1 gelesen</translation>
    </message>
    <message>
        <source>Save the program</source>
        <translation>Programm speichern</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>%1 could not be saved</source>
        <translation>%1 konnte nicht gespeichert werden</translation>
    </message>
    <message>
        <source>Program saved as %1</source>
        <translation>Programm als %1 gespeichert</translation>
    </message>
    <message>
        <source>Program from passes</source>
        <translation>Programm aus Schnitten</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>&amp;Schreiben</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>r/min</source>
        <translation>1/min</translation>
    </message>
    <message>
        <source>Writing the program</source>
        <translation>Programm wird geschrieben</translation>
    </message>
    <message>
        <source>The passes cannot be written as a program</source>
        <translation>Die Schnitte lassen sich nicht als Programm schreiben</translation>
    </message>
    <message>
        <source>Rough and finish</source>
        <translation>Schruppen und schlichten</translation>
    </message>
    <message>
        <source>Depth of cut</source>
        <translation>Schnitttiefe</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>Nose radius</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>Feed of roughing</source>
        <translation>Vorschub beim Schruppen</translation>
    </message>
    <message>
        <source>mm/rev</source>
        <translation>mm/U</translation>
    </message>
    <message>
        <source>Feed of finishing</source>
        <translation>Vorschub beim Schlichten</translation>
    </message>
    <message>
        <source>Surface speed</source>
        <translation>Schnittgeschwindigkeit</translation>
    </message>
    <message>
        <source>m/min</source>
        <translation>m/min</translation>
    </message>
    <message>
        <source>Writing and simulating the cycles</source>
        <translation>Zyklen werden geschrieben und simuliert</translation>
    </message>
    <message>
        <source>There are no cycles for this target</source>
        <translation>Für dieses Ziel gibt es keine Zyklen</translation>
    </message>
    <message>
        <source>Run the program first.</source>
        <translation>Lassen Sie zuerst das Programm laufen.</translation>
    </message>
    <message>
        <source>Running the program</source>
        <translation>Programm läuft</translation>
    </message>
    <message>
        <source>The program could not be run</source>
        <translation>Das Programm konnte nicht ausgeführt werden</translation>
    </message>
    <message>
        <source>The run was cancelled.</source>
        <translation>Der Lauf wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Cut the part as the program does: one step of the history</source>
        <translation>Das Teil schneiden wie das Programm: ein Schritt im Verlauf</translation>
    </message>
    <message>
        <source>The program does not touch the part.</source>
        <translation>Das Programm berührt das Teil nicht.</translation>
    </message>
    <message>
        <source>collision: the tip is beyond the face of the chuck, at ⌀ %1, Z %2.</source>
        <translation>Kollision: Die Spitze ist jenseits der Futterstirnfläche, bei ⌀ %1, Z %2.</translation>
    </message>
    <message>
        <source>collision: a rapid move through material, to ⌀ %1, Z %2.</source>
        <translation>Kollision: eine Eilgangbewegung durch Material, nach ⌀ %1, Z %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n collision(s).</source>
        <translation>
            <numerusform>%n Kollision.</numerusform>
            <numerusform>%n Kollisionen.</numerusform>
        </translation>
    </message>
    <message>
        <source>No collision.</source>
        <translation>Keine Kollision.</translation>
    </message>
    <message>
        <source>The program does not touch the part. %1</source>
        <translation>Das Programm berührt das Teil nicht. %1</translation>
    </message>
    <message>
        <source>Time with tool changes %1. It removes %2 mm³. %3</source>
        <translation>Zeit mit Werkzeugwechseln %1. Es trägt %2 mm³ ab. %3</translation>
    </message>
    <message>
        <source>Run program</source>
        <translation>Programm ausführen</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>%1 ausführen</translation>
    </message>
    <message>
        <source>Cutting up to the line</source>
        <translation>Schnitte bis zur Zeile werden berechnet</translation>
    </message>
    <message>
        <source>collision: a feed into material with the spindle at rest, to ⌀ %1, Z %2.</source>
        <translation>Kollision: ein Vorschub in das Material bei stehender Spindel, nach ⌀ %1, Z %2.</translation>
    </message>
    <message>
        <source>Drill for the bore</source>
        <translation>Bohrer für die Bohrung</translation>
    </message>
    <message>
        <source>collision: %3 meets %4, on the way to ⌀ %1, Z %2.</source>
        <translation>Kollision: %3 trifft auf %4, auf dem Weg nach ⌀ %1, Z %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n collision(s) recorded, which undo does not take back.</source>
        <translation>
            <numerusform>%n Kollision aufgezeichnet, die „Rückgängig“ nicht zurücknimmt.</numerusform>
            <numerusform>%n Kollisionen aufgezeichnet, die „Rückgängig“ nicht zurücknimmt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Change the tools of the program</source>
        <translation>Werkzeuge des Programms ändern</translation>
    </message>
    <message>
        <source>Writes a program that makes the target from this part, a bore included, through or blind. It is simulated first, and refused where it collides or cuts into the target.</source>
        <translation>Schreibt ein Programm, das aus diesem Teil das Ziel macht, auch mit einer Durchgangs- oder Sacklochbohrung. Es wird zuerst simuliert und abgelehnt, wo es kollidiert oder in das Ziel schneidet.</translation>
    </message>
    <message>
        <source>Diameter. A bore, through or blind, is drilled, roughed and finished with a boring bar; 0 leaves it as it is.</source>
        <translation>Durchmesser. Eine Durchgangs- oder Sacklochbohrung wird gebohrt und mit einem Innendrehmeißel geschruppt und geschlichtet; 0 lässt sie, wie sie ist.</translation>
    </message>
    <message>
        <source>The view shows the part as it is. Run the program to see what it would cut.</source>
        <translation>Die Ansicht zeigt das Teil, wie es ist. Führen Sie das Programm aus, um zu sehen, was es abtragen würde.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>…and %1 more, in the list of the program.</source>
        <translation>… und %1 weitere, in der Liste des Programms.</translation>
    </message>
    <message numerus="yes">
        <source>The program has %n collision(s); nothing is cut yet</source>
        <translation>
            <numerusform>Das Programm hat %n Kollision; noch ist nichts zerspant</numerusform>
            <numerusform>Das Programm hat %n Kollisionen; noch ist nichts zerspant</numerusform>
        </translation>
    </message>
    <message>
        <source>If you cut anyway, collisions are recorded as on the machine, and undo does not take them back.</source>
        <translation>Wenn Sie trotzdem zerspanen, werden Kollisionen wie an der Maschine aufgezeichnet, und „Rückgängig“ nimmt sie nicht zurück.</translation>
    </message>
    <message>
        <source>Cut anyway</source>
        <translation>Trotzdem zerspanen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Depth of a roughing cut, on the radius</source>
        <translation>Tiefe eines Schruppschnitts, am Radius</translation>
    </message>
    <message>
        <source>Allowance for the finishing cut</source>
        <translation>Aufmaß für den Schlichtschnitt</translation>
    </message>
    <message>
        <source>Largest spindle speed</source>
        <translation>Höchste Drehzahl</translation>
    </message>
    <message>
        <source>resultant force: up to %1 N, where the lathe of the exercise allows %2 N. It is in the report of the exercise.</source>
        <translation>Zerspankraft: bis zu %1 N, wo die Drehmaschine der Übung %2 N erlaubt. Das steht im Bericht der Übung.</translation>
    </message>
    <message>
        <source>motor power: up to %1 kW, where the lathe of the exercise has %2 kW. It is in the report of the exercise.</source>
        <translation>Motorleistung: bis zu %1 kW, wo die Drehmaschine der Übung %2 kW hat. Das steht im Bericht der Übung.</translation>
    </message>
    <message>
        <source>Cut the part as the program does. If it collides, its collisions are shown first.</source>
        <translation>Das Teil schneiden wie das Programm. Wenn es kollidiert, werden vorher seine Kollisionen gezeigt.</translation>
    </message>
    <message>
        <source>Cut: %1 mm³ removed. Undo restores them.</source>
        <translation>Bearbeitet: %1 mm³ abgetragen. „Rückgängig“ stellt sie wieder her.</translation>
    </message>
    <message>
        <source>The program or the part was changed since: run it again.</source>
        <translation>Programm oder Teil wurde seitdem geändert: führen Sie es erneut aus.</translation>
    </message>
    <message>
        <source>This exercise is to be done by hand: it does not allow programs to be made, run, or to cut.</source>
        <translation>Diese Übung ist von Hand zu machen: Programme dürfen nicht erstellt, ausgeführt oder zum Schneiden benutzt werden.</translation>
    </message>
    <message>
        <source>The passes that cut this part become a program in the chosen dialect, with their feed per revolution. It is shown in the editor; undo restores the present text.</source>
        <translation>Die Durchgänge, die dieses Teil geschnitten haben, werden zu einem Programm im gewählten Dialekt, mit ihrem Vorschub je Umdrehung. Es steht im Editor; Rückgängig stellt den jetzigen Text wieder her.</translation>
    </message>
    <message>
        <source>The program leaves material over the target</source>
        <translation>Das Programm lässt Material über dem Ziel stehen</translation>
    </message>
    <message>
        <source>In the bore it is up to %1 mm, at Z %2 mm.</source>
        <translation>In der Bohrung sind es bis zu %1 mm, bei Z %2 mm.</translation>
    </message>
    <message>
        <source>It is up to %1 mm, at Z %2 mm.</source>
        <translation>Es sind bis zu %1 mm, bei Z %2 mm.</translation>
    </message>
    <message>
        <source>Cut the rest by hand, or by a program of your own.</source>
        <translation>Schneiden Sie den Rest von Hand oder mit einem eigenen Programm.</translation>
    </message>
    <message>
        <source>Choose a drill of %1 mm for the bore.</source>
        <translation>Wählen Sie für die Bohrung einen Bohrer von %1 mm.</translation>
    </message>
    <message>
        <source>No drill makes it: %1.</source>
        <translation>Kein Bohrer macht sie: %1.</translation>
    </message>
    <message>
        <source>Nothing was cut yet.</source>
        <translation>Es wurde noch nichts zerspant.</translation>
    </message>
    <message>
        <source>There is no target.</source>
        <translation>Es gibt kein Ziel.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The others are named at the head of the program.</source>
        <translation>Die übrigen stehen am Kopf des Programms.</translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es) were left out of the program</source>
        <translation>
            <numerusform>%n Schnitt wurde aus dem Programm weggelassen</numerusform>
            <numerusform>%n Schnitte wurden aus dem Programm weggelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>Do their work by hand, after the program.</source>
        <translation>Machen Sie deren Arbeit nach dem Programm von Hand.</translation>
    </message>
    <message>
        <source>Change the tool post</source>
        <translation>Werkzeugträger ändern</translation>
    </message>
    <message>
        <source>collision: a feed into material with the spindle at rest, which M6 has stopped, to ⌀ %1, Z %2. Write M3 or M4 after M6.</source>
        <translation>Kollision: ein Vorschub in das Material bei stehender Spindel, die M6 angehalten hat, nach ⌀ %1, Z %2. Schreiben Sie M3 oder M4 hinter M6.</translation>
    </message>
</context>
<context>
    <name>handwheel::PropertyRow</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>handwheel::ProximityDock</name>
    <message>
        <source>Distance &amp;queries…</source>
        <translation>Abstands&amp;abfragen…</translation>
    </message>
    <message>
        <source>Measures what the distances of the robot from its obstacles cost, in three scenarios</source>
        <translation>Misst, was die Abstände des Roboters von seinen Hindernissen kosten, in drei Szenarien</translation>
    </message>
    <message>
        <source>Distance queries</source>
        <translation>Abstandsabfragen</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Szenario</translation>
    </message>
    <message>
        <source>Where it stands</source>
        <translation>Wo er steht</translation>
    </message>
    <message>
        <source>1: apart by more than the tolerance</source>
        <translation>1: weiter entfernt als die Toleranz</translation>
    </message>
    <message>
        <source>2: nearer than the tolerance</source>
        <translation>2: näher als die Toleranz</translation>
    </message>
    <message>
        <source>3: colliding</source>
        <translation>3: in Kollision</translation>
    </message>
    <message>
        <source>&amp;Measure the distance queries</source>
        <translation>Abstandsabfragen &amp;messen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Costs of the distance queries</source>
        <translation>Kosten der Abstandsabfragen</translation>
    </message>
    <message>
        <source>CPU time (µs)</source>
        <translation>CPU-Zeit (µs)</translation>
    </message>
    <message>
        <source>At most (µs)</source>
        <translation>Höchstens (µs)</translation>
    </message>
    <message>
        <source>C1 closest points</source>
        <translation>C1 nächste Punkte</translation>
    </message>
    <message>
        <source>C2 nearer than tolerance</source>
        <translation>C2 näher als die Toleranz</translation>
    </message>
    <message>
        <source>C3 colliding</source>
        <translation>C3 in Kollision</translation>
    </message>
    <message>
        <source>C4 all contacts</source>
        <translation>C4 alle Kontakte</translation>
    </message>
    <message>
        <source>CPU time of a step: the median, and the largest. Pairs of bounding volumes, and of triangles or solids, that were compared in a step: the mean</source>
        <translation>CPU-Zeit eines Schritts: der Median und die größte. Paare von Hüllkörpern und von Dreiecken oder Körpern, die in einem Schritt verglichen wurden: das Mittel</translation>
    </message>
    <message>
        <source>The cell is being prepared.</source>
        <translation>Die Zelle wird vorbereitet.</translation>
    </message>
    <message>
        <source>The queries are being measured.</source>
        <translation>Die Abfragen werden gemessen.</translation>
    </message>
    <message>
        <source>Nothing is measured yet.</source>
        <translation>Noch ist nichts gemessen.</translation>
    </message>
    <message>
        <source>%1 The cell was changed since.</source>
        <translation>%1 Die Zelle wurde seitdem geändert.</translation>
    </message>
    <message>
        <source>The cell could not be prepared.</source>
        <translation>Die Zelle konnte nicht vorbereitet werden.</translation>
    </message>
    <message>
        <source>Measuring the distance queries</source>
        <translation>Abstandsabfragen werden gemessen</translation>
    </message>
    <message>
        <source>The robot does not get into scenario %1.</source>
        <translation>Der Roboter kommt nicht in das Szenario %1.</translation>
    </message>
    <message>
        <source>Scenario 1, apart: there is no obstacle.</source>
        <translation>Szenario 1, entfernt: Es gibt kein Hindernis.</translation>
    </message>
    <message>
        <source>Scenario 1, apart: %1 from the nearest obstacle.</source>
        <translation>Szenario 1, entfernt: %1 vom nächsten Hindernis.</translation>
    </message>
    <message>
        <source>Scenario 2, near: %1 from the nearest obstacle.</source>
        <translation>Szenario 2, nahe: %1 vom nächsten Hindernis.</translation>
    </message>
    <message numerus="yes">
        <source>Scenario 3, colliding: %Ln pair(s) of triangles or solids meet.</source>
        <translation>
            <numerusform>Szenario 3, in Kollision: %Ln Paar von Dreiecken oder Körpern trifft sich.</numerusform>
            <numerusform>Szenario 3, in Kollision: %Ln Paare von Dreiecken oder Körpern treffen sich.</numerusform>
        </translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Hüllkörper</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
</context>
<context>
    <name>handwheel::ReadOnlyRow</name>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
</context>
<context>
    <name>handwheel::RecordingIndicator</name>
    <message>
        <source>The device is being recorded. Click to show the recordings</source>
        <translation>Das Gerät wird aufgezeichnet. Klicken, um die Aufzeichnungen zu zeigen</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Aufzeichnung %1</translation>
    </message>
</context>
<context>
    <name>handwheel::Recordings</name>
    <message>
        <source>&amp;Record the device</source>
        <translation>Gerät &amp;aufzeichnen</translation>
    </message>
    <message>
        <source>&amp;Play the recording</source>
        <translation>Aufzeichnung ab&amp;spielen</translation>
    </message>
    <message>
        <source>&amp;Leave the recording</source>
        <translation>Aufzeichnung &amp;verlassen</translation>
    </message>
    <message>
        <source>&amp;Export as CSV…</source>
        <translation>Als &amp;CSV exportieren…</translation>
    </message>
    <message>
        <source>Re&amp;name the recording</source>
        <translation>Aufzeichnung &amp;umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete the recording</source>
        <translation>Aufzeichnung &amp;löschen</translation>
    </message>
    <message>
        <source>Let the cursor follow the recording, or pause it</source>
        <translation>Den Zeiger der Aufzeichnung folgen lassen, oder anhalten</translation>
    </message>
    <message>
        <source>Show the device again</source>
        <translation>Wieder das Gerät zeigen</translation>
    </message>
    <message>
        <source>Write the recording as a table</source>
        <translation>Die Aufzeichnung als Tabelle schreiben</translation>
    </message>
    <message>
        <source>Give the recording another name</source>
        <translation>Der Aufzeichnung einen anderen Namen geben</translation>
    </message>
    <message>
        <source>Delete the recording from the document</source>
        <translation>Die Aufzeichnung aus dem Dokument löschen</translation>
    </message>
    <message>
        <source>Rename a recording</source>
        <translation>Eine Aufzeichnung umbenennen</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Aufzeichnung %1</translation>
    </message>
    <message>
        <source>Record the device</source>
        <translation>Gerät aufzeichnen</translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln sample(s)</source>
        <translation>
            <numerusform>%1: %Ln Messwert</numerusform>
            <numerusform>%1: %Ln Messwerte</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete a recording</source>
        <translation>Eine Aufzeichnung löschen</translation>
    </message>
    <message>
        <source>Export the recording</source>
        <translation>Aufzeichnung exportieren</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>%1 could not be saved</source>
        <translation>%1 konnte nicht gespeichert werden</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Stop &amp;recording</source>
        <translation>Aufzeichnung &amp;beenden</translation>
    </message>
    <message>
        <source>&amp;Pause the recording</source>
        <translation>Aufzeichnung &amp;anhalten</translation>
    </message>
    <message>
        <source>Record the position and the force of the device until pressed again</source>
        <translation>Position und Kraft des Geräts bis zum nächsten Druck aufzeichnen</translation>
    </message>
</context>
<context>
    <name>handwheel::RecordingsPage</name>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Position in the recording</source>
        <translation>Stelle in der Aufzeichnung</translation>
    </message>
    <message numerus="yes">
        <source>%1, %Ln sample(s)</source>
        <translation>
            <numerusform>%1, %Ln Messwert</numerusform>
            <numerusform>%1, %Ln Messwerte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %Ln missing</source>
        <translation>
            <numerusform>, %Ln fehlt</numerusform>
            <numerusform>, %Ln fehlen</numerusform>
        </translation>
    </message>
    <message>
        <source>Kept with the document.</source>
        <translation>Bleibt beim Dokument.</translation>
    </message>
</context>
<context>
    <name>handwheel::RemeshAction</name>
    <message>
        <source>Make &amp;mesh…</source>
        <translation>&amp;Netz erzeugen…</translation>
    </message>
    <message>
        <source>Open the surface as a mesh, with as many triangles as are wanted</source>
        <translation>Die Oberfläche als Netz öffnen, mit so vielen Dreiecken wie gewünscht</translation>
    </message>
    <message>
        <source>Make a mesh</source>
        <translation>Ein Netz erzeugen</translation>
    </message>
    <message>
        <source>The mesh becomes a document of its own. It is closed and manifold, and meets itself nowhere.</source>
        <translation>Das Netz wird ein eigenes Dokument. Es ist geschlossen und mannigfaltig und durchdringt sich nirgends.</translation>
    </message>
    <message>
        <source>&amp;Make mesh</source>
        <translation>&amp;Netz erzeugen</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>being counted…</source>
        <translation>wird gezählt…</translation>
    </message>
    <message>
        <source>Counting triangles</source>
        <translation>Dreiecke werden gezählt</translation>
    </message>
    <message>
        <source>Making the mesh</source>
        <translation>Netz wird erzeugt</translation>
    </message>
    <message>
        <source>The mesh was not made</source>
        <translation>Das Netz wurde nicht erzeugt</translation>
    </message>
    <message>
        <source>Mesh made of %1 triangle(s): %2 of them left</source>
        <translation>Netz aus %1 Dreieck(en) erzeugt: %2 davon übrig</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>etwa %1 s</translation>
    </message>
</context>
<context>
    <name>handwheel::RepairActions</name>
    <message>
        <source>&amp;Repair all</source>
        <translation>Alles &amp;reparieren</translation>
    </message>
    <message>
        <source>Remove &amp;debris</source>
        <translation>&amp;Bruchstücke entfernen</translation>
    </message>
    <message>
        <source>&amp;Go one by one</source>
        <translation>&amp;Einzeln durchgehen</translation>
    </message>
    <message>
        <source>&amp;Fill</source>
        <translation>&amp;Füllen</translation>
    </message>
    <message>
        <source>&amp;Keep open</source>
        <translation>&amp;Offen lassen</translation>
    </message>
    <message>
        <source>&amp;Preview</source>
        <translation>Vor&amp;schau</translation>
    </message>
    <message>
        <source>&amp;Next hole</source>
        <translation>&amp;Nächstes Loch</translation>
    </message>
    <message>
        <source>Pre&amp;vious hole</source>
        <translation>&amp;Voriges Loch</translation>
    </message>
    <message>
        <source>&amp;Clear selection</source>
        <translation>&amp;Auswahl aufheben</translation>
    </message>
    <message>
        <source>Look at one hole after the other</source>
        <translation>Ein Loch nach dem anderen ansehen</translation>
    </message>
    <message>
        <source>Fill the selected hole</source>
        <translation>Ausgewähltes Loch füllen</translation>
    </message>
    <message>
        <source>Show the patch of the selected hole before it is filled</source>
        <translation>Füllfläche des ausgewählten Lochs vor dem Füllen zeigen</translation>
    </message>
    <message>
        <source>Go to the next hole</source>
        <translation>Zum nächsten Loch gehen</translation>
    </message>
    <message>
        <source>Go to the previous hole</source>
        <translation>Zum vorigen Loch gehen</translation>
    </message>
    <message>
        <source>Clear the selection and the preview</source>
        <translation>Auswahl und Vorschau aufheben</translation>
    </message>
    <message>
        <source>Mark this opening as intended: “Repair all” does not close it</source>
        <translation>Diese Öffnung als beabsichtigt markieren: „Alles reparieren“ schließt sie nicht</translation>
    </message>
    <message>
        <source>&amp;Undo repair</source>
        <translation>Reparatur &amp;rückgängig</translation>
    </message>
    <message>
        <source>Remove all pieces that are listed as debris; the list says which these are</source>
        <translation>Alle Stücke entfernen, die als Bruchstücke gelistet sind; die Liste sagt, welche das sind</translation>
    </message>
    <message>
        <source>Repair by &amp;volume…</source>
        <translation>Vol&amp;umetrisch reparieren…</translation>
    </message>
    <message>
        <source>Choose the size of the voxels, and replace everything by the surface of the volume that is enclosed</source>
        <translation>Die Größe der Voxel wählen und alles durch die Oberfläche des eingeschlossenen Volumens ersetzen</translation>
    </message>
    <message>
        <source>Fill all holes except those kept open, resolve self-intersections, and repair the other defects except debris, as one step</source>
        <translation>Alle Löcher außer den offen gelassenen füllen, Selbstdurchdringungen auflösen und die anderen Fehler außer Bruchstücken beheben, in einem Schritt</translation>
    </message>
    <message>
        <source>Undo all that the last repair has changed</source>
        <translation>Alles rückgängig machen, was die letzte Reparatur geändert hat</translation>
    </message>
    <message>
        <source>The last repair has tried it; the list says why defects remain.</source>
        <translation>Die letzte Reparatur hat es versucht; die Liste sagt, warum Fehler bleiben.</translation>
    </message>
    <message>
        <source>Self-intersections are still being searched for.</source>
        <translation>Selbstdurchdringungen werden noch gesucht.</translation>
    </message>
    <message>
        <source>There is nothing that it would repair.</source>
        <translation>Es gibt nichts, was sie reparieren würde.</translation>
    </message>
    <message>
        <source>There is no debris.</source>
        <translation>Es gibt keine Bruchstücke.</translation>
    </message>
    <message>
        <source>There are no holes.</source>
        <translation>Es gibt keine Löcher.</translation>
    </message>
    <message>
        <source>Select a hole first.</source>
        <translation>Zuerst ein Loch auswählen.</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>Nichts ist ausgewählt.</translation>
    </message>
    <message>
        <source>The last change was not a repair.</source>
        <translation>Die letzte Änderung war keine Reparatur.</translation>
    </message>
    <message>
        <source>This opening is marked as intended.</source>
        <translation>Diese Öffnung ist als gewollt markiert.</translation>
    </message>
    <message>
        <source>No patch fits; the list says why.</source>
        <translation>Keine Füllfläche passt; die Liste sagt, warum.</translation>
    </message>
</context>
<context>
    <name>handwheel::RepairDemo</name>
    <message>
        <source>&amp;Watch the hand repair a scan</source>
        <translation>&amp;Zusehen, wie die Hand einen Scan repariert</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>The hand opens the sample</source>
        <translation>Die Hand öffnet das Beispiel</translation>
    </message>
    <message>
        <source>1 of 5: choose the hole</source>
        <translation>1 von 5: das Loch wählen</translation>
    </message>
    <message>
        <source>3 of 5: stitch</source>
        <translation>3 von 5: nähen</translation>
    </message>
    <message>
        <source>4 of 5: fill both parts</source>
        <translation>4 von 5: beide Teile füllen</translation>
    </message>
    <message>
        <source>5 of 5: sculpt the patch</source>
        <translation>5 von 5: die Füllfläche modellieren</translation>
    </message>
    <message>
        <source>The seam of both patches is smoothed as a part of the whole surface.</source>
        <translation>Die Naht zwischen beiden Füllflächen wird als Teil der ganzen Oberfläche geglättet.</translation>
    </message>
    <message>
        <source>The simulated hand repairs a hole of the sample with the same tools that you have</source>
        <translation>Die simulierte Hand repariert ein Loch des Beispiels mit denselben Werkzeugen, die Sie haben</translation>
    </message>
    <message>
        <source>You can do the same with a device or with the mouse.</source>
        <translation>Sie können dasselbe mit einem Gerät oder mit der Maus tun.</translation>
    </message>
    <message>
        <source>Boundary vertices attract the tip. The first button chooses the hole.</source>
        <translation>Randeckpunkte ziehen die Spitze an. Die erste Taste wählt das Loch.</translation>
    </message>
    <message>
        <source>2 of 5: smooth its boundary</source>
        <translation>2 von 5: den Rand glätten</translation>
    </message>
    <message>
        <source>Shift+S shows a preview. The second button applies it.</source>
        <translation>Umschalt+S zeigt eine Vorschau. Die zweite Taste übernimmt sie.</translation>
    </message>
    <message>
        <source>A vertex is pulled to the opposite one: the longer the pull, the stronger the force. The hole is divided into two.</source>
        <translation>Ein Eckpunkt wird zum gegenüberliegenden gezogen: Je weiter, desto stärker die Kraft. Das Loch wird in zwei geteilt.</translation>
    </message>
    <message>
        <source>The first button shows the patch of a hole, the second fills the hole with it.</source>
        <translation>Die erste Taste zeigt die Füllfläche eines Lochs, die zweite füllt das Loch damit.</translation>
    </message>
    <message>
        <source>It is subdivided and dragged at its coarse level; the fine level follows as if on a spring.</source>
        <translation>Sie wird unterteilt und auf ihrer groben Stufe gezogen; die feine Stufe folgt wie an einer Feder.</translation>
    </message>
</context>
<context>
    <name>handwheel::RepairJobs</name>
    <message>
        <source>Filling hole %1</source>
        <translation>Loch %1 wird gefüllt</translation>
    </message>
    <message>
        <source>%1 stays open: %2</source>
        <translation>%1 bleibt offen: %2</translation>
    </message>
    <message>
        <source>Fill hole %1</source>
        <translation>Loch %1 füllen</translation>
    </message>
    <message>
        <source>Filled %1 of %2</source>
        <translation>%1 von %2 gefüllt</translation>
    </message>
    <message>
        <source>Repairing %1</source>
        <translation>%1 wird repariert</translation>
    </message>
    <message>
        <source>Repair all</source>
        <translation>Alles reparieren</translation>
    </message>
    <message>
        <source>Repaired %1: %2</source>
        <translation>%1 repariert: %2</translation>
    </message>
    <message>
        <source>%1 was changed again; the result was discarded</source>
        <translation>%1 wurde erneut geändert; das Ergebnis wurde verworfen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Why: %1.</source>
        <translation>Grund: %1.</translation>
    </message>
    <message>
        <source>Save your work, and try it on a smaller part or in another way.</source>
        <translation>Speichern Sie Ihre Arbeit, und versuchen Sie es an einem kleineren Teil oder auf anderem Weg.</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1: fehlgeschlagen</translation>
    </message>
    <message>
        <source>The document is as it was before. %1</source>
        <translation>Das Dokument ist, wie es vorher war. %1</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n more pair(s) of triangles intersect; undo reverts this</source>
        <translation>
            <numerusform>%1: %n Paar Dreiecke mehr durchdringt sich; Rückgängig nimmt das zurück</numerusform>
            <numerusform>%1: %n Paare von Dreiecken mehr durchdringen sich; Rückgängig nimmt das zurück</numerusform>
        </translation>
    </message>
    <message>
        <source>A hole opened by the repair</source>
        <translation>Ein durch die Reparatur entstandenes Loch</translation>
    </message>
    <message>
        <source>%1 was changed meanwhile; the job runs again</source>
        <translation>%1 wurde inzwischen geändert; der Vorgang läuft noch einmal</translation>
    </message>
    <message>
        <source>%1: %2 by %3</source>
        <translation>%1: %2 um %3</translation>
    </message>
    <message numerus="yes">
        <source>%Ln whole piece(s) deleted</source>
        <translation>
            <numerusform>%Ln ganzes Stück gelöscht</numerusform>
            <numerusform>%Ln ganze Stücke gelöscht</numerusform>
        </translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>%1: %2: %3</source>
        <translation>%1: %2: %3</translation>
    </message>
    <message>
        <source>largest distance found between the surface before and after %1</source>
        <translation>größter gefundener Abstand zwischen der Oberfläche vorher und nachher %1</translation>
    </message>
    <message>
        <source>Repaired %1: nothing was changed</source>
        <translation>%1 repariert: nichts wurde geändert</translation>
    </message>
    <message>
        <source>Nothing more could be repaired without damage. The list of defects gives the reasons that are known.</source>
        <translation>Mehr ließ sich nicht ohne Schaden reparieren. Die Liste der Fehler nennt die bekannten Gründe.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s) were removed from %1.</source>
        <translation>
            <numerusform>%Ln Dreieck wurde aus %1 entfernt.</numerusform>
            <numerusform>%Ln Dreiecke wurden aus %1 entfernt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Check the patch of %1: %2.</source>
        <translation>Prüfen Sie die Füllfläche von %1: %2.</translation>
    </message>
    <message>
        <source>walls thinner than a voxel were lost: choose smaller voxels</source>
        <translation>Wände dünner als ein Voxel gingen verloren: kleinere Voxel wählen</translation>
    </message>
    <message>
        <source>Open a mesh first.</source>
        <translation>Zuerst ein Netz öffnen.</translation>
    </message>
    <message>
        <source>The mesh is being changed.</source>
        <translation>Das Netz wird gerade geändert.</translation>
    </message>
</context>
<context>
    <name>handwheel::ReplayDock</name>
    <message>
        <source>round tool, R %1 mm</source>
        <translation>rundes Werkzeug, R %1 mm</translation>
    </message>
    <message>
        <source>&amp;Replay</source>
        <translation>&amp;Wiedergabe</translation>
    </message>
    <message>
        <source>Plays the passes that cut the part, on a time line</source>
        <translation>Spielt die Schnitte, die das Teil erzeugt haben, auf einer Zeitleiste ab</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Preparing the replay</source>
        <translation>Wiedergabe wird vorbereitet</translation>
    </message>
    <message>
        <source>Distance from the axis</source>
        <translation>Abstand von der Achse</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Pass %1: %2</source>
        <translation>Schnitt %1: %2</translation>
    </message>
    <message>
        <source>Pass %1 of %2: %3, at R %4 mm, Z %5 mm</source>
        <translation>Schnitt %1 von %2: %3, bei R %4 mm, Z %5 mm</translation>
    </message>
    <message>
        <source>Crash: %1, %2</source>
        <translation>Kollision: %1, %2</translation>
    </message>
    <message>
        <source>Resultant force</source>
        <translation>Zerspankraft</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Motor power</source>
        <translation>Motorleistung</translation>
    </message>
    <message>
        <source>kW</source>
        <translation>kW</translation>
    </message>
    <message>
        <source>Material left over the target</source>
        <translation>Restmaterial über dem Ziel</translation>
    </message>
    <message>
        <source>Cut too deep</source>
        <translation>Zu tief geschnitten</translation>
    </message>
    <message>
        <source>&amp;Compare with…</source>
        <translation>&amp;Vergleichen mit…</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>Workpieces (%1)</source>
        <translation>Werkstücke (%1)</translation>
    </message>
    <message>
        <source>%1 cannot be compared</source>
        <translation>%1 lässt sich nicht vergleichen</translation>
    </message>
    <message>
        <source>&amp;Leave %1</source>
        <translation>&amp;Vergleich mit %1 beenden</translation>
    </message>
    <message>
        <source>Nothing has been cut yet. Recorded passes can be played here.</source>
        <translation>Es wurde noch nichts zerspant. Aufgezeichnete Schnitte können hier abgespielt werden.</translation>
    </message>
    <message>
        <source>It is not a workpiece that was cut.</source>
        <translation>Es ist kein Werkstück, das bearbeitet wurde.</translation>
    </message>
    <message>
        <source>Showing the replay</source>
        <translation>Wiedergabe wird gezeigt</translation>
    </message>
    <message>
        <source>threading tool, R %1 mm</source>
        <translation>Gewindewerkzeug, R %1 mm</translation>
    </message>
</context>
<context>
    <name>handwheel::ReshapeActions</name>
    <message>
        <source>Make s&amp;hell…</source>
        <translation>&amp;Schale erzeugen…</translation>
    </message>
    <message>
        <source>Leave a wall along the surface</source>
        <translation>Eine Wand entlang der Oberfläche stehen lassen</translation>
    </message>
    <message>
        <source>Move s&amp;urface…</source>
        <translation>&amp;Oberfläche versetzen…</translation>
    </message>
    <message>
        <source>Move the surface out or in</source>
        <translation>Die Oberfläche nach außen oder innen versetzen</translation>
    </message>
    <message>
        <source>C&amp;ombine…</source>
        <translation>&amp;Kombinieren…</translation>
    </message>
    <message>
        <source>Unite with another document or file, subtract it, or keep what both have</source>
        <translation>Mit einem anderen Dokument oder einer Datei vereinigen, dieses oder diese abziehen, oder behalten, was beide gemeinsam haben</translation>
    </message>
    <message>
        <source>Remove &amp;debris…</source>
        <translation>B&amp;ruchstücke entfernen…</translation>
    </message>
    <message>
        <source>Take small parts away</source>
        <translation>Kleine Teile entfernen</translation>
    </message>
    <message>
        <source>Close &amp;gaps…</source>
        <translation>&amp;Lücken schließen…</translation>
    </message>
    <message>
        <source>Fill gaps, cracks and pits</source>
        <translation>Lücken, Risse und Vertiefungen füllen</translation>
    </message>
    <message>
        <source>Smooth &amp;all…</source>
        <translation>&amp;Alles glätten…</translation>
    </message>
    <message>
        <source>Take small bumps and dents off</source>
        <translation>Kleine Beulen und Dellen abtragen</translation>
    </message>
    <message>
        <source>Change &amp;whole volume</source>
        <translation>&amp;Ganzes Volumen ändern</translation>
    </message>
    <message>
        <source>Shell, moved surface, combination with another body, debris, gaps, smoothing</source>
        <translation>Schale, versetzte Oberfläche, Kombination mit einem anderen Körper, Bruchstücke, Lücken, Glättung</translation>
    </message>
    <message>
        <source>The volume cannot be changed like that</source>
        <translation>Das Volumen lässt sich so nicht ändern</translation>
    </message>
    <message>
        <source>Combine with</source>
        <translation>Kombinieren mit</translation>
    </message>
</context>
<context>
    <name>handwheel::ResultTable</name>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Sort by “%1”</source>
        <translation>Sortieren nach „%1“</translation>
    </message>
    <message>
        <source>First column of the results</source>
        <translation>Erste Spalte der Ergebnisse</translation>
    </message>
</context>
<context>
    <name>handwheel::RigidPartsHaptics</name>
    <message>
        <source>Preparing to touch</source>
        <translation>Berührung wird vorbereitet</translation>
    </message>
</context>
<context>
    <name>handwheel::RobotCellUi</name>
    <message>
        <source>Open the sample &amp;robot</source>
        <translation>Beispiel-&amp;Roboter öffnen</translation>
    </message>
    <message>
        <source>Open the sample robot arm</source>
        <translation>Beispiel-Roboterarm öffnen</translation>
    </message>
    <message>
        <source>Robot cell</source>
        <translation>Roboterzelle</translation>
    </message>
    <message>
        <source>Move &amp;joints by hand</source>
        <translation>&amp;Gelenke von Hand bewegen</translation>
    </message>
    <message numerus="yes">
        <source>Robot %1: %Ln joint(s) that move.</source>
        <translation>
            <numerusform>Roboter %1: %Ln bewegliches Gelenk.</numerusform>
            <numerusform>Roboter %1: %Ln bewegliche Gelenke.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln joint(s)</source>
        <translation>
            <numerusform>%Ln Gelenk</numerusform>
            <numerusform>%Ln Gelenke</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Cell</source>
        <translation>&amp;Zelle</translation>
    </message>
    <message>
        <source>Drag the links of the robot, and the bodies beside it</source>
        <translation>Die Glieder des Roboters und die Körper daneben ziehen</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln body(ies)</source>
        <translation>
            <numerusform>%Ln Körper</numerusform>
            <numerusform>%Ln Körper</numerusform>
        </translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Type another position in the panel.</source>
        <translation>Geben Sie im Bereich eine andere Position ein.</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>It is at the position given in its file; everything else is transparent while it is selected.</source>
        <translation>Er hat die Position aus seiner Datei; alles andere ist durchsichtig, solange er ausgewählt ist.</translation>
    </message>
    <message>
        <source>Drag a link with the mouse, or the whole arm with Shift. Type angles in the list of joints. Add bodies beside the robot in the panel.</source>
        <translation>Ziehen Sie ein Glied mit der Maus oder mit Umschalt den ganzen Arm. Geben Sie Winkel in der Liste der Gelenke ein. Fügen Sie im Feld Körper neben dem Roboter hinzu.</translation>
    </message>
    <message>
        <source>%1 is inside another object</source>
        <translation>%1 liegt in einem anderen Objekt</translation>
    </message>
    <message>
        <source>Opened %1: robot %2 with %3 and %4</source>
        <translation>%1 geöffnet: Roboter %2 mit %3 und %4</translation>
    </message>
    <message numerus="yes">
        <source>%n link(s)</source>
        <translation>
            <numerusform>%n Glied</numerusform>
            <numerusform>%n Gliedern</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s) that move</source>
        <translation>
            <numerusform>%n beweglichen Gelenk</numerusform>
            <numerusform>%n beweglichen Gelenken</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;New cell with a built-in robot…</source>
        <translation>&amp;Neue Zelle mit mitgeliefertem Roboter…</translation>
    </message>
    <message>
        <source>New cell</source>
        <translation>Neue Zelle</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>Planung</translation>
    </message>
    <message>
        <source>&amp;Process path along a curve</source>
        <translation>&amp;Bearbeitungsbahn entlang einer Kurve</translation>
    </message>
    <message>
        <source>Choose an edge or a section of a part for the robot&apos;s tool to work along</source>
        <translation>Eine Kante oder einen Schnitt eines Teils wählen, an dem das Werkzeug entlangarbeitet</translation>
    </message>
    <message>
        <source>Open the sample robot &amp;cell</source>
        <translation>Beispiel-Roboter&amp;zelle öffnen</translation>
    </message>
    <message>
        <source>Opens a sample cell. Plan a path from left to right, or lead the robot along an edge by hand.</source>
        <translation>Öffnet eine Beispielzelle. Planen Sie eine Bahn von links nach rechts, oder führen Sie den Roboter von Hand an einer Kante entlang.</translation>
    </message>
    <message>
        <source>&amp;Lead the robot by hand</source>
        <translation>Roboter von Hand &amp;führen</translation>
    </message>
    <message>
        <source>&amp;Choose the arm&apos;s configuration</source>
        <translation>&amp;Stellung des Arms wählen</translation>
    </message>
    <message>
        <source>Lay a body &amp;face to face</source>
        <translation>Körper Fläche &amp;auf Fläche legen</translation>
    </message>
    <message>
        <source>Lay a body with one of its faces on a face of another</source>
        <translation>Einen Körper mit einer seiner Flächen auf eine Fläche eines anderen legen</translation>
    </message>
    <message>
        <source>Place a body or robot with &amp;handles</source>
        <translation>&amp;Körper oder Roboter mit Griffen platzieren</translation>
    </message>
    <message>
        <source>Move and turn the selected body, or the base of the selected robot, along and about axes</source>
        <translation>Den gewählten Körper oder die Basis des gewählten Roboters entlang von Achsen bewegen und um Achsen drehen</translation>
    </message>
    <message>
        <source>%1 cannot be moved</source>
        <translation>%1 lässt sich nicht bewegen</translation>
    </message>
    <message>
        <source>Everything in the cell is measured from the base of its first robot.</source>
        <translation>Alles in der Zelle wird von der Basis ihres ersten Roboters aus gemessen.</translation>
    </message>
    <message>
        <source>Move the bodies and the other robots.</source>
        <translation>Bewegen Sie die Körper und die anderen Roboter.</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>Robo&amp;ter</translation>
    </message>
    <message>
        <source>&amp;Bodies</source>
        <translation>Körp&amp;er</translation>
    </message>
    <message>
        <source>P&amp;aths</source>
        <translation>Ba&amp;hnen</translation>
    </message>
    <message>
        <source>Verif&amp;ication</source>
        <translation>&amp;Prüfung</translation>
    </message>
    <message>
        <source>Pro&amp;grams</source>
        <translation>Progra&amp;mme</translation>
    </message>
    <message>
        <source>Lead the robot&apos;s tool by hand; the arm follows without collisions</source>
        <translation>Das Werkzeug des Roboters von Hand führen; der Arm folgt ohne Kollisionen</translation>
    </message>
    <message>
        <source>Show all configurations in which the arm reaches a pose of its tool: shoulder, elbow and wrist</source>
        <translation>Alle Stellungen zeigen, in denen der Arm eine Pose seines Werkzeugs erreicht: Schulter, Ellbogen und Handgelenk</translation>
    </message>
    <message>
        <source>Open a robot in front of a block on a table, with a path along its edge</source>
        <translation>Einen Roboter vor einem Block auf einem Tisch öffnen, mit einer Bahn entlang der Blockkante</translation>
    </message>
    <message>
        <source>Create a cell with a robot of the library, from its manufacturer&apos;s data</source>
        <translation>Eine Zelle mit einem Roboter der Bibliothek erstellen, nach den Daten seines Herstellers</translation>
    </message>
    <message>
        <source>C&amp;onfigurations, targets and frames</source>
        <translation>St&amp;ellungen, Ziele und Bezugssysteme</translation>
    </message>
    <message>
        <source>&amp;Place it beside the others</source>
        <translation>Neben die anderen &amp;stellen</translation>
    </message>
    <message>
        <source>Go to where the path was shown</source>
        <translation>Dorthin, wo die Bahn gezeigt wurde</translation>
    </message>
</context>
<context>
    <name>handwheel::RoundTargetDialog</name>
    <message>
        <source>Round the target</source>
        <translation>Ziel runden</translation>
    </message>
    <message>
        <source>&amp;Round</source>
        <translation>&amp;Runden</translation>
    </message>
    <message>
        <source>Rounding the target</source>
        <translation>Ziel wird gerundet</translation>
    </message>
    <message>
        <source>A surface of the target changes by %1 at most.</source>
        <translation>Eine Fläche des Ziels ändert sich um höchstens %1.</translation>
    </message>
</context>
<context>
    <name>handwheel::RunningAttempt</name>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Teil wird gemessen</translation>
    </message>
    <message>
        <source>It could not be handed in</source>
        <translation>Es konnte nicht abgegeben werden</translation>
    </message>
    <message>
        <source>The exercise that %1 belongs to cannot be read</source>
        <translation>Die Übung, zu der %1 gehört, ist nicht lesbar</translation>
    </message>
    <message>
        <source>Hand in</source>
        <translation>Abgeben</translation>
    </message>
    <message>
        <source>Handwheel documents (%1)</source>
        <translation>Handwheel-Dokumente (%1)</translation>
    </message>
    <message>
        <source>%1 is open, and would be replaced.</source>
        <translation>%1 ist geöffnet und würde ersetzt.</translation>
    </message>
    <message>
        <source>Choose another name for the file.</source>
        <translation>Wählen Sie einen anderen Namen für die Datei.</translation>
    </message>
    <message>
        <source>Handing in</source>
        <translation>Arbeit wird abgegeben</translation>
    </message>
    <message>
        <source>Handed in by %1</source>
        <translation>Abgegeben von %1</translation>
    </message>
    <message>
        <source>The work is in %1.</source>
        <translation>Die Arbeit liegt in %1.</translation>
    </message>
    <message>
        <source>Give that file to your teacher.</source>
        <translation>Geben Sie diese Datei Ihrer Lehrkraft.</translation>
    </message>
    <message>
        <source>Preparing the exercise</source>
        <translation>Übung wird vorbereitet</translation>
    </message>
    <message>
        <source>Checking the steps</source>
        <translation>Schritte werden geprüft</translation>
    </message>
    <message>
        <source>Work on %1</source>
        <translation>Arbeit an %1</translation>
    </message>
    <message>
        <source>Work of %1 on %2</source>
        <translation>Arbeit von %1 an %2</translation>
    </message>
    <message>
        <source>Steps of the exercise, with the buttons to measure and to hand in the work</source>
        <translation>Schritte der Übung, mit den Tasten zum Messen und zum Abgeben der Arbeit</translation>
    </message>
    <message>
        <source>Some of it cannot be measured: %1</source>
        <translation>Einiges davon kann nicht gemessen werden: %1</translation>
    </message>
    <message>
        <source>Give that file to your teacher, or go on with the work and hand it in once more.</source>
        <translation>Diese Datei der Lehrkraft geben, oder weiterarbeiten und noch einmal abgeben.</translation>
    </message>
</context>
<context>
    <name>handwheel::ScriptExport</name>
    <message>
        <source>Save s&amp;teps…</source>
        <translation>Sch&amp;ritte speichern…</translation>
    </message>
    <message>
        <source>Write what was done to the mesh as a file that “handwheel edit --steps” reads</source>
        <translation>Schreibt, was mit dem Netz getan wurde, als Datei, die „handwheel edit --steps“ liest</translation>
    </message>
    <message>
        <source>Save steps</source>
        <translation>Schritte speichern</translation>
    </message>
    <message>
        <source>Steps (%1)</source>
        <translation>Schritte (%1)</translation>
    </message>
    <message>
        <source>%1 was not written</source>
        <translation>%1 wurde nicht geschrieben</translation>
    </message>
    <message>
        <source>%1 could not be saved</source>
        <translation>%1 konnte nicht gespeichert werden</translation>
    </message>
    <message>
        <source>Saved the steps as %1</source>
        <translation>Schritte als %1 gespeichert</translation>
    </message>
    <message>
        <source>There is no file from which the steps reproduce the current state.</source>
        <translation>Es gibt keine Datei, aus der die Schritte den jetzigen Stand erzeugen.</translation>
    </message>
    <message>
        <source>Save the document as *.handwheel, and continue from there.</source>
        <translation>Speichern Sie das Dokument als *.handwheel, und arbeiten Sie von dort aus weiter.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Open a mesh first.</source>
        <translation>Zuerst ein Netz öffnen.</translation>
    </message>
</context>
<context>
    <name>handwheel::SectionView</name>
    <message>
        <source>Cutting</source>
        <translation>Schnitt wird berechnet</translation>
    </message>
    <message>
        <source>Area (%1)</source>
        <translation>Fläche (%1)</translation>
    </message>
</context>
<context>
    <name>handwheel::Segmentation</name>
    <message>
        <source>&amp;Segmentation</source>
        <translation>&amp;Segmentierung</translation>
    </message>
    <message>
        <source>Segmentation</source>
        <translation>Segmentierung</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Smoothing the segment</source>
        <translation>Segment wird geglättet</translation>
    </message>
    <message>
        <source>Smooth segment</source>
        <translation>Segment glätten</translation>
    </message>
    <message>
        <source>Counting parts</source>
        <translation>Teile werden gezählt</translation>
    </message>
    <message>
        <source>Choose values</source>
        <translation>Werte wählen</translation>
    </message>
    <message>
        <source>Erase from segment</source>
        <translation>Aus dem Segment radieren</translation>
    </message>
    <message>
        <source>Paint segment</source>
        <translation>Segment malen</translation>
    </message>
    <message>
        <source>Keeping the largest parts</source>
        <translation>Größte Teile werden behalten</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n largest part(s)</source>
        <translation>
            <numerusform>%n größten Teil behalten</numerusform>
            <numerusform>%n größte Teile behalten</numerusform>
        </translation>
    </message>
    <message>
        <source>Growing from the point</source>
        <translation>Segment wächst vom Punkt aus</translation>
    </message>
    <message>
        <source>Grow from point</source>
        <translation>Vom Punkt aus wachsen</translation>
    </message>
    <message>
        <source>Making the surface</source>
        <translation>Oberfläche wird erzeugt</translation>
    </message>
    <message>
        <source>The surface was not made</source>
        <translation>Die Oberfläche wurde nicht erzeugt</translation>
    </message>
    <message>
        <source>Make surface</source>
        <translation>Oberfläche erzeugen</translation>
    </message>
    <message>
        <source>Choose the material of a scan in its slices</source>
        <translation>Das Material eines Scans in seinen Schichten wählen</translation>
    </message>
    <message>
        <source>The point (value %1) is not in the segment. Click a coloured place, or choose a range that includes this value.</source>
        <translation>Der Punkt (Wert %1) liegt nicht im Segment. Klicken Sie eine farbige Stelle an, oder wählen Sie einen Bereich, der diesen Wert enthält.</translation>
    </message>
</context>
<context>
    <name>handwheel::SegmentationPanel</name>
    <message>
        <source>Lower end of the range</source>
        <translation>Unteres Ende des Bereichs</translation>
    </message>
    <message>
        <source>Upper end of the range</source>
        <translation>Oberes Ende des Bereichs</translation>
    </message>
    <message>
        <source>&amp;Otsu</source>
        <translation>&amp;Otsu</translation>
    </message>
    <message>
        <source>&amp;Bone</source>
        <translation>&amp;Knochen</translation>
    </message>
    <message>
        <source>&amp;Skin</source>
        <translation>&amp;Haut</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>&amp;Largest part only</source>
        <translation>Nur größter &amp;Teil</translation>
    </message>
    <message>
        <source>&amp;Keep so many</source>
        <translation>&amp;So viele behalten</translation>
    </message>
    <message>
        <source>&amp;Remove debris</source>
        <translation>&amp;Bruchstücke entfernen</translation>
    </message>
    <message>
        <source>S&amp;mooth</source>
        <translation>&amp;Glätten</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Cross&amp;hair</source>
        <translation>Fa&amp;denkreuz</translation>
    </message>
    <message>
        <source>Click to move the crosshair</source>
        <translation>Klicken, um das Fadenkreuz zu bewegen</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>&amp;Malen</translation>
    </message>
    <message>
        <source>Adds to the segment; Ctrl: erases. [ and ]: radius</source>
        <translation>Fügt zum Segment hinzu; Strg: radiert. [ und ]: Radius</translation>
    </message>
    <message>
        <source>&amp;Erase</source>
        <translation>&amp;Radieren</translation>
    </message>
    <message>
        <source>Erases from the segment; Ctrl: adds. [ and ]: radius</source>
        <translation>Radiert aus dem Segment; Strg: fügt hinzu. [ und ]: Radius</translation>
    </message>
    <message>
        <source>&amp;Grow from point</source>
        <translation>&amp;Vom Punkt aus wachsen</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Radius des Pinsels</translation>
    </message>
    <message>
        <source>Ball (&amp;3D)</source>
        <translation>Kugel (&amp;3D)</translation>
    </message>
    <message>
        <source>In the slices</source>
        <translation>In den Schichten</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Level of the greys</source>
        <translation>Mitte der Graustufen</translation>
    </message>
    <message>
        <source>Width of the greys</source>
        <translation>Breite der Graustufen</translation>
    </message>
    <message>
        <source>Greys</source>
        <translation>Graustufen</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Edge of a voxel</source>
        <translation>Kantenlänge eines Voxels</translation>
    </message>
    <message>
        <source>Smooth &amp;it</source>
        <translation>Oberfläche g&amp;lätten</translation>
    </message>
    <message>
        <source>Make s&amp;urface</source>
        <translation>Oberfläche &amp;erzeugen</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Voxel</source>
        <translation>Voxel</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s), %1 mm³; the largest is %2 % of it</source>
        <translation>
            <numerusform>%n Teil, %1 mm³; der größte ist %2 % davon</numerusform>
            <numerusform>%n Teile, %1 mm³; der größte ist %2 % davon</numerusform>
        </translation>
    </message>
    <message>
        <source>Counting parts…</source>
        <translation>Teile werden gezählt…</translation>
    </message>
    <message>
        <source>Value %1 at x %2, y %3, z %4 mm</source>
        <translation>Wert %1 bei x %2, y %3, z %4 mm</translation>
    </message>
    <message>
        <source>Below %1 mm³: %2 of %3 parts, %4 mm³</source>
        <translation>Unter %1 mm³: %2 von %3 Teilen, %4 mm³</translation>
    </message>
    <message>
        <source>From Otsu&apos;s threshold upwards, which best separates the values into two classes</source>
        <translation>Ab dem Otsu-Schwellenwert, der die Werte am besten in zwei Klassen trennt</translation>
    </message>
    <message>
        <source>300 Hounsfield units and above</source>
        <translation>Ab 300 Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>-200 Hounsfield units and above: everything except air</source>
        <translation>Ab -200 Hounsfield-Einheiten: alles außer Luft</translation>
    </message>
    <message>
        <source>Keeps only the largest connected part</source>
        <translation>Behält nur den größten zusammenhängenden Teil</translation>
    </message>
    <message>
        <source>Number of largest parts to keep</source>
        <translation>Anzahl der größten Teile, die behalten werden</translation>
    </message>
    <message>
        <source>Keeps this number of the largest parts</source>
        <translation>Behält diese Anzahl der größten Teile</translation>
    </message>
    <message>
        <source>Volume below which parts are debris</source>
        <translation>Volumen, unter dem Teile Bruchstücke sind</translation>
    </message>
    <message>
        <source>Removes all parts smaller than this</source>
        <translation>Entfernt alle Teile, die kleiner sind als dies</translation>
    </message>
    <message>
        <source>Removes specks and smooths steps: each sample follows the majority of its 3 × 3 × 3 neighbourhood</source>
        <translation>Entfernt Flecken und glättet Stufen: Jeder Abtastwert folgt der Mehrheit seiner Umgebung von 3 × 3 × 3</translation>
    </message>
    <message>
        <source>Click a point of the segment: only the part connected to it is kept</source>
        <translation>Klicken Sie einen Punkt des Segments an: Nur der Teil, der mit ihm zusammenhängt, wird behalten</translation>
    </message>
    <message>
        <source>The brush is a ball that reaches into neighbouring slices; otherwise it paints in one slice</source>
        <translation>Der Pinsel ist eine Kugel, die in benachbarte Schichten reicht; sonst malt er in einer Schicht</translation>
    </message>
    <message>
        <source>Smooths the voxel steps of the surface</source>
        <translation>Glättet die Voxelstufen der Oberfläche</translation>
    </message>
    <message>
        <source>Creates the volume of the segment, which can be shaped, drilled and saved; undo restores the previous one</source>
        <translation>Erzeugt das Volumen des Segments, das geformt, gebohrt und gespeichert werden kann; „Rückgängig“ stellt das vorige wieder her</translation>
    </message>
    <message>
        <source>Edited by hand: choosing another range discards these edits (undo restores them).</source>
        <translation>Von Hand bearbeitet: Die Wahl eines anderen Bereichs verwirft diese Änderungen („Rückgängig“ stellt sie wieder her).</translation>
    </message>
    <message>
        <source>No sample has a value in this range.</source>
        <translation>Kein Abtastwert hat einen Wert in diesem Bereich.</translation>
    </message>
    <message>
        <source>About %1 MB of %2 MB available</source>
        <translation>Etwa %1 MB der verfügbaren %2 MB</translation>
    </message>
    <message>
        <source>Larger voxels need less.</source>
        <translation>Größere Voxel brauchen weniger.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>The region of the image that is taken</source>
        <translation>Der Bereich des Bildes, der genommen wird</translation>
    </message>
    <message>
        <source>Patient&apos;s left at the le&amp;ft</source>
        <translation>Linke Seite des Patienten &amp;links</translation>
    </message>
    <message>
        <source>Shows slices as seen from the head and from the back; otherwise the patient&apos;s right is at the left, as radiologists have it</source>
        <translation>Zeigt die Schichten von Kopf und Rücken her gesehen; sonst liegt die rechte Seite des Patienten links, wie in der Radiologie üblich</translation>
    </message>
    <message>
        <source>All labels</source>
        <translation>Alle Labels</translation>
    </message>
    <message>
        <source>The volume was made from an earlier segment.</source>
        <translation>Das Volumen stammt von einem früheren Segment.</translation>
    </message>
</context>
<context>
    <name>handwheel::SelfIntersectionSearch</name>
    <message>
        <source>Searching self-intersections</source>
        <translation>Selbstdurchdringungen werden gesucht</translation>
    </message>
</context>
<context>
    <name>handwheel::ServiceModel</name>
    <message>
        <source>%1 % of the frame</source>
        <translation>%1 % des Bildes</translation>
    </message>
    <message>
        <source>%1 % of the servo tick</source>
        <translation>%1 % des Regeltakts</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>Service</source>
        <translation>Dienst</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Ticks/s</source>
        <translation>Takte/s</translation>
    </message>
    <message>
        <source>µs per tick</source>
        <translation>µs je Takt</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>too slow by %1 %</source>
        <translation>um %1 % zu langsam</translation>
    </message>
    <message numerus="yes">
        <source>%n input(s) dropped</source>
        <translation>
            <numerusform>%n Eingabe verloren</numerusform>
            <numerusform>%n Eingaben verloren</numerusform>
        </translation>
    </message>
    <message>
        <source>idle</source>
        <translation>untätig</translation>
    </message>
</context>
<context>
    <name>handwheel::SessionDevicePanel</name>
    <message>
        <source>along (Z)</source>
        <translation>längs (Z)</translation>
    </message>
    <message>
        <source>radius (X)</source>
        <translation>Radius (X)</translation>
    </message>
    <message>
        <source>across</source>
        <translation>quer</translation>
    </message>
</context>
<context>
    <name>handwheel::ShellActions</name>
    <message>
        <source>Split into s&amp;hells</source>
        <translation>In &amp;Schalen teilen</translation>
    </message>
    <message>
        <source>&amp;Add a mesh…</source>
        <translation>Netz &amp;hinzufügen…</translation>
    </message>
    <message numerus="yes">
        <source>Split into %Ln shell(s)</source>
        <translation>
            <numerusform>In %Ln Schale geteilt</numerusform>
            <numerusform>In %Ln Schalen geteilt</numerusform>
        </translation>
    </message>
    <message>
        <source>The mesh is one shell</source>
        <translation>Das Netz ist eine einzige Schale</translation>
    </message>
    <message numerus="yes">
        <source>There are %Ln shell(s)</source>
        <translation>
            <numerusform>Es gibt %Ln Schale</numerusform>
            <numerusform>Es gibt %Ln Schalen</numerusform>
        </translation>
    </message>
    <message>
        <source>Add a mesh</source>
        <translation>Netz hinzufügen</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>%1 could not be added</source>
        <translation>%1 konnte nicht hinzugefügt werden</translation>
    </message>
    <message>
        <source>The shells could not be opened</source>
        <translation>Die Schalen konnten nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Open each shell (triangles connected across edges) as a separate document</source>
        <translation>Jede Schale (über Kanten zusammenhängende Dreiecke) als eigenes Dokument öffnen</translation>
    </message>
    <message>
        <source>Add the mesh of another file to this one, at its own position</source>
        <translation>Das Netz einer anderen Datei an seiner eigenen Position zu diesem hinzufügen</translation>
    </message>
    <message>
        <source>“handwheel split” writes that many into a folder. Debris can be removed first.</source>
        <translation>„handwheel split“ schreibt so viele in einen Ordner. Vorher lassen sich Bruchstücke entfernen.</translation>
    </message>
</context>
<context>
    <name>handwheel::ShortcutEditor</name>
    <message>
        <source>No key</source>
        <translation>Keine Taste</translation>
    </message>
    <message>
        <source>The command has no key any more</source>
        <translation>Der Befehl hat keine Taste mehr</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>The other commands lose this key</source>
        <translation>Die anderen Befehle verlieren diese Taste</translation>
    </message>
    <message>
        <source>Search by name or key</source>
        <translation>Nach Name oder Taste suchen</translation>
    </message>
    <message>
        <source>Search commands and keys</source>
        <translation>Befehle und Tasten suchen</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>New key of the chosen command</source>
        <translation>Neue Taste des gewählten Befehls</translation>
    </message>
    <message>
        <source>Press the new key here</source>
        <translation>Neue Taste hier drücken</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Write the changed keys to a file</source>
        <translation>Geänderte Tasten in eine Datei schreiben</translation>
    </message>
    <message>
        <source>Choose a command to change its key.</source>
        <translation>Wählen Sie einen Befehl, um seine Taste zu ändern.</translation>
    </message>
    <message>
        <source>”, “</source>
        <translation>“, „</translation>
    </message>
    <message>
        <source>Import keys</source>
        <translation>Tasten importieren</translation>
    </message>
    <message>
        <source>Keys (*.json)</source>
        <translation>Tasten (*.json)</translation>
    </message>
    <message>
        <source>Export keys</source>
        <translation>Tasten exportieren</translation>
    </message>
    <message>
        <source>Restore the default key</source>
        <translation>Standardtaste wiederherstellen</translation>
    </message>
    <message>
        <source>Reassign</source>
        <translation>Neu zuweisen</translation>
    </message>
    <message>
        <source>Restore all default keys</source>
        <translation>Alle Standardtasten wiederherstellen</translation>
    </message>
    <message>
        <source>Read the keys from a file</source>
        <translation>Tasten aus einer Datei lesen</translation>
    </message>
    <message>
        <source>“%1” has the same key, so neither works.</source>
        <translation>„%1“ hat dieselbe Taste, daher wirkt keine von beiden.</translation>
    </message>
    <message>
        <source>“%1” has the same key. In the view, the key acts on the active tool.</source>
        <translation>„%1“ hat dieselbe Taste. In der Ansicht wirkt sie auf das aktive Werkzeug.</translation>
    </message>
    <message>
        <source>The keys were imported.</source>
        <translation>Die Tasten wurden importiert.</translation>
    </message>
    <message>
        <source>The changed keys were exported.</source>
        <translation>Die geänderten Tasten wurden exportiert.</translation>
    </message>
</context>
<context>
    <name>handwheel::ShortcutModel</name>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Return, Enter and Esc end what a tool does. No other command can have them.</source>
        <translation>Eingabetaste, Enter und Esc beenden, was ein Werkzeug tut. Kein anderer Befehl kann sie haben.</translation>
    </message>
    <message>
        <source>In every tool Return finishes and Esc cancels: these keys cannot be changed.</source>
        <translation>In jedem Werkzeug schließt die Eingabetaste ab und Esc bricht ab: Diese Tasten lassen sich nicht ändern.</translation>
    </message>
    <message>
        <source>This key does not exist.</source>
        <translation>Eine solche Taste gibt es nicht.</translation>
    </message>
    <message>
        <source>In a tool, a shortcut must be a single key press.</source>
        <translation>In einem Werkzeug muss ein Kürzel aus einem einzigen Tastendruck bestehen.</translation>
    </message>
</context>
<context>
    <name>handwheel::SimulationBanner</name>
    <message>
        <source>Simulated – not cut yet</source>
        <translation>Simuliert – noch nicht zerspant</translation>
    </message>
    <message>
        <source>&amp;Cut the work</source>
        <translation>Werkstück &amp;zerspanen</translation>
    </message>
    <message>
        <source>The view shows what the program would cut. The document, and what is saved, is the part before it.</source>
        <translation>Die Ansicht zeigt, was das Programm abtragen würde. Das Dokument, und was gespeichert wird, ist das Teil davor.</translation>
    </message>
    <message>
        <source>Show the part as it is</source>
        <translation>Das Teil zeigen, wie es ist</translation>
    </message>
    <message>
        <source>Leave the simulation; the program stays as it is</source>
        <translation>Die Simulation verlassen; das Programm bleibt, wie es ist</translation>
    </message>
</context>
<context>
    <name>handwheel::SlicesPanel</name>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Wheel, Page up and down: slices. Right button: level and width of the greys. Ctrl+wheel, + and -: zoom; middle button: move. Shift+click, arrows: crosshair. Space: the chosen tool there.</source>
        <translation>Rad, Bild auf und Bild ab: Schichten. Rechte Taste: Mitte und Breite der Graustufen. Strg+Rad, + und -: zoomen; mittlere Taste: verschieben. Umschalt+Klick, Pfeile: Fadenkreuz. Leertaste: das gewählte Werkzeug an dieser Stelle.</translation>
    </message>
    <message>
        <source>%1 slice</source>
        <translation>Schicht, %1</translation>
    </message>
    <message>
        <source>%1 %2 of %3</source>
        <translation>%1 %2 von %3</translation>
    </message>
</context>
<context>
    <name>handwheel::SlowdownLabel</name>
    <message>
        <source>The computer does not keep up. Nothing is left out: the simulation runs slower than the clock.</source>
        <translation>Der Computer kommt nicht mit. Nichts wird ausgelassen: Die Simulation läuft langsamer als die Uhr.</translation>
    </message>
    <message>
        <source>Simulation at %1 % of real time</source>
        <translation>Simulation mit %1 % der Echtzeit</translation>
    </message>
</context>
<context>
    <name>handwheel::SpaceMouseNavigation</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
</context>
<context>
    <name>handwheel::StampAction</name>
    <message>
        <source>Load s&amp;tamp…</source>
        <translation>S&amp;tempel laden…</translation>
    </message>
    <message>
        <source>Shape clay by the brightness of a picture, or by the height of a part</source>
        <translation>Ton nach der Helligkeit eines Bildes oder der Höhe eines Teils formen</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.gif *.pgm *.ppm *.pbm)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.bmp *.gif *.pgm *.ppm *.pbm)</translation>
    </message>
    <message>
        <source>Load a stamp</source>
        <translation>Stempel laden</translation>
    </message>
    <message>
        <source>Loading a stamp</source>
        <translation>Stempel wird geladen</translation>
    </message>
    <message>
        <source>The stamp cannot be loaded</source>
        <translation>Der Stempel kann nicht geladen werden</translation>
    </message>
</context>
<context>
    <name>handwheel::StartPage</name>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Datei öffnen…</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt verwendete Dateien</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Clear the list of recent files</source>
        <translation>Liste der zuletzt verwendeten Dateien leeren</translation>
    </message>
    <message>
        <source>Or drop files anywhere on this window</source>
        <translation>Oder Dateien irgendwo auf dieses Fenster ziehen</translation>
    </message>
    <message>
        <source>The sample is not installed.</source>
        <translation>Das Beispiel ist nicht installiert.</translation>
    </message>
    <message>
        <source>Repair scans, shape clay, practise at lathe and drill, arrange robot cells.</source>
        <translation>Scans reparieren, Ton formen, an Drehmaschine und Bohrer üben, Roboterzellen einrichten.</translation>
    </message>
</context>
<context>
    <name>handwheel::StateCard</name>
    <message>
        <source>Watertight</source>
        <translation>Wasserdicht</translation>
    </message>
    <message numerus="yes">
        <source>%Ln hole(s)</source>
        <translation>
            <numerusform>%Ln Loch</numerusform>
            <numerusform>%Ln Löcher</numerusform>
        </translation>
    </message>
    <message>
        <source>Not manifold</source>
        <translation>Nicht mannigfaltig</translation>
    </message>
    <message>
        <source>Not oriented</source>
        <translation>Nicht orientiert</translation>
    </message>
    <message>
        <source>Self-intersecting</source>
        <translation>Selbstdurchdringend</translation>
    </message>
    <message>
        <source>Inside out</source>
        <translation>Innenseite außen</translation>
    </message>
    <message numerus="yes">
        <source>%Ln reversed on opening</source>
        <translation>
            <numerusform>%Ln beim Öffnen umgekehrt</numerusform>
            <numerusform>%Ln beim Öffnen umgekehrt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln open sheet(s)</source>
        <translation>
            <numerusform>%Ln offene Fläche</numerusform>
            <numerusform>%Ln offene Flächen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln hole(s) kept open</source>
        <translation>
            <numerusform>%Ln Loch bleibt offen</numerusform>
            <numerusform>%Ln Löcher bleiben offen</numerusform>
        </translation>
    </message>
    <message>
        <source>No holes</source>
        <translation>Keine Löcher</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>self-intersections not known yet</source>
        <translation>Selbstdurchdringungen noch nicht bekannt</translation>
    </message>
    <message>
        <source>Inconsistently oriented</source>
        <translation>Uneinheitlich orientiert</translation>
    </message>
</context>
<context>
    <name>handwheel::StatusPanel</name>
    <message>
        <source>Services</source>
        <translation>Dienste</translation>
    </message>
</context>
<context>
    <name>handwheel::SubmissionsView</name>
    <message>
        <source>&amp;Mark…</source>
        <translation>Be&amp;werten…</translation>
    </message>
    <message>
        <source>Mark files that students have handed in</source>
        <translation>Dateien bewerten, die Schüler abgegeben haben</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>Beri&amp;cht…</translation>
    </message>
    <message>
        <source>&amp;Table…</source>
        <translation>&amp;Tabelle…</translation>
    </message>
    <message>
        <source>Submissions</source>
        <translation>Abgaben</translation>
    </message>
    <message>
        <source>&amp;Compare…</source>
        <translation>&amp;Vergleichen…</translation>
    </message>
    <message>
        <source>Write a report of the two selected works side by side (Ctrl+click selects a second one)</source>
        <translation>Einen Bericht der zwei ausgewählten Arbeiten nebeneinander schreiben (Strg+Klick wählt eine zweite aus)</translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected works from the class; their files stay</source>
        <translation>Die gewählten Arbeiten aus der Klasse entfernen; ihre Dateien bleiben</translation>
    </message>
</context>
<context>
    <name>handwheel::SuggestedTextRow</name>
    <message>
        <source>Choose from a list</source>
        <translation>Aus einer Liste wählen</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>Wählen: %1</translation>
    </message>
</context>
<context>
    <name>handwheel::SuggestionCard</name>
    <message>
        <source>Do not show this card for this document again</source>
        <translation>Diese Karte für dieses Dokument nicht mehr zeigen</translation>
    </message>
    <message>
        <source>Show the details and all actions</source>
        <translation>Einzelheiten und alle Aktionen zeigen</translation>
    </message>
    <message>
        <source>Fold this card to one line</source>
        <translation>Diese Karte auf eine Zeile falten</translation>
    </message>
</context>
<context>
    <name>handwheel::TargetActions</name>
    <message>
        <source>Import &amp;target…</source>
        <translation>&amp;Ziel importieren…</translation>
    </message>
    <message>
        <source>&amp;Remove target</source>
        <translation>Ziel &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Deviation in colours</source>
        <translation>&amp;Abweichung in Farben</translation>
    </message>
    <message>
        <source>Show where the part is larger or smaller than the target</source>
        <translation>Zeigen, wo das Teil größer oder kleiner als das Ziel ist</translation>
    </message>
    <message>
        <source>Remove target</source>
        <translation>Ziel entfernen</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Teil wird gemessen</translation>
    </message>
    <message>
        <source>Import a target</source>
        <translation>Ein Ziel importieren</translation>
    </message>
    <message>
        <source>Turned parts (%1)</source>
        <translation>Drehteile (%1)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Import target</source>
        <translation>Ziel importieren</translation>
    </message>
    <message>
        <source>Target read from %1</source>
        <translation>Ziel aus %1 gelesen</translation>
    </message>
    <message>
        <source>&amp;Target in the view</source>
        <translation>Ziel in der A&amp;nsicht</translation>
    </message>
    <message>
        <source>Rou&amp;ghness in colours</source>
        <translation>Rau&amp;heit in Farben</translation>
    </message>
    <message>
        <source>Show the outline of the target over the part</source>
        <translation>Den Umriss des Ziels über dem Teil zeigen</translation>
    </message>
    <message>
        <source>Show how rough the part is, from feed and nose of its last cuts</source>
        <translation>Zeigen, wie rau das Teil ist, aus Vorschub und Eckenradius seiner letzten Schnitte</translation>
    </message>
    <message>
        <source>Target of the exercise</source>
        <translation>Ziel der Übung</translation>
    </message>
    <message>
        <source>Where the target lies</source>
        <translation>Wo das Ziel liegt</translation>
    </message>
    <message>
        <source>The finished face of the part is zero of the drawing and of programs. The bar goes beyond it by what is left for facing. It can be changed later in the panel Stock.</source>
        <translation>Die fertige Planfläche des Teils ist der Nullpunkt der Zeichnung und der Programme. Die Stange ragt um das Aufmaß zum Plandrehen darüber hinaus. Es lässt sich später im Feld „Rohteil“ ändern.</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importieren</translation>
    </message>
    <message>
        <source>blue: Ra %1 µm or less, white: %2, red: %3 or more, grey: unknown</source>
        <translation>blau: Ra höchstens %1 µm, weiß: %2, rot: mindestens %3, grau: unbekannt</translation>
    </message>
    <message>
        <source>Import the target shape of the part from STEP, DXF, SVG or a workpiece</source>
        <translation>Die Zielform des Teils aus STEP, DXF, SVG oder einem Werkstück importieren</translation>
    </message>
    <message>
        <source>Do not compare the part with a target</source>
        <translation>Das Teil nicht mit einem Ziel vergleichen</translation>
    </message>
    <message>
        <source>%1 cannot be used as a target</source>
        <translation>%1 kann nicht als Ziel verwendet werden</translation>
    </message>
    <message>
        <source>Turn the target &amp;end for end</source>
        <translation>Ziel &amp;umdrehen</translation>
    </message>
    <message>
        <source>Make the end at the chuck the free one, whose face is finished</source>
        <translation>Das Ende am Futter zum freien machen, dessen Planfläche bearbeitet wird</translation>
    </message>
    <message>
        <source>Turn the target end for end</source>
        <translation>Ziel umdrehen</translation>
    </message>
    <message>
        <source>The target is that of the exercise.</source>
        <translation>Das Ziel ist das der Übung.</translation>
    </message>
    <message>
        <source>Open a workpiece first.</source>
        <translation>Zuerst ein Werkstück öffnen.</translation>
    </message>
    <message>
        <source>There is no target.</source>
        <translation>Es gibt kein Ziel.</translation>
    </message>
</context>
<context>
    <name>handwheel::TargetPanel</name>
    <message>
        <source>Bore %1</source>
        <translation>Bohrung %1</translation>
    </message>
    <message>
        <source>Measured dimensions</source>
        <translation>Gemessene Maße</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Dimensions</source>
        <translation>Maße</translation>
    </message>
    <message>
        <source>No target: import one to compare the part with it.</source>
        <translation>Kein Ziel: Importieren Sie eines, um das Teil damit zu vergleichen.</translation>
    </message>
    <message>
        <source>Too large by up to %1</source>
        <translation>Zu groß um bis zu %1</translation>
    </message>
    <message>
        <source>Too small by up to %1</source>
        <translation>Zu klein um bis zu %1</translation>
    </message>
    <message>
        <source>blue: %1 too small, red: %1 too large</source>
        <translation>blau: %1 zu klein, rot: %1 zu groß</translation>
    </message>
    <message>
        <source>Curve ⌀ %1 … %2</source>
        <translation>Kurve ⌀ %1 … %2</translation>
    </message>
</context>
<context>
    <name>handwheel::TargetPlacementView</name>
    <message>
        <source>The target in its bar; the free end is on the right</source>
        <translation>Das Ziel in seiner Stange; das freie Ende ist rechts</translation>
    </message>
    <message>
        <source>Grey: the target. Blue: what is cut off the bar</source>
        <translation>Grau: das Ziel. Blau: was von der Stange abgeschnitten wird</translation>
    </message>
    <message>
        <source>← chuck</source>
        <translation>← Futter</translation>
    </message>
    <message>
        <source>Turn &amp;end for end</source>
        <translation>&amp;Umdrehen</translation>
    </message>
    <message>
        <source>Make the end at the chuck the free one, whose face is finished</source>
        <translation>Das Ende am Futter zum freien machen, dessen Stirnfläche bearbeitet wird</translation>
    </message>
    <message>
        <source>free end →</source>
        <translation>freies Ende →</translation>
    </message>
</context>
<context>
    <name>handwheel::ThreadAction</name>
    <message>
        <source>T&amp;hread…</source>
        <translation>&amp;Gewinde…</translation>
    </message>
    <message>
        <source>Cut a thread outside or in a bore, between two heights</source>
        <translation>Ein Gewinde außen oder in einer Bohrung schneiden, zwischen zwei Höhen</translation>
    </message>
    <message>
        <source>Cutting the thread</source>
        <translation>Gewinde wird geschnitten</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Gewinde</translation>
    </message>
    <message>
        <source>The exercise does not allow it: cut the thread on the lathe, by its half-nut.</source>
        <translation>Die Übung erlaubt es nicht: Schneiden Sie das Gewinde an der Drehmaschine, mit der Schlossmutter.</translation>
    </message>
    <message>
        <source>Open a workpiece first.</source>
        <translation>Öffnen Sie zuerst ein Werkstück.</translation>
    </message>
</context>
<context>
    <name>handwheel::ThreadDialog</name>
    <message>
        <source>Thread</source>
        <translation>Gewinde</translation>
    </message>
    <message>
        <source>&amp;Cut</source>
        <translation>&amp;Schneiden</translation>
    </message>
    <message>
        <source>ISO metric profile: the bottom of the groove is at a diameter of %1.</source>
        <translation>Metrisches ISO-Profil: Der Rillengrund liegt auf einem Durchmesser von %1.</translation>
    </message>
    <message>
        <source>The bottom of the groove is at a diameter of %1.</source>
        <translation>Der Rillengrund liegt auf einem Durchmesser von %1.</translation>
    </message>
</context>
<context>
    <name>handwheel::TickTiming</name>
    <message>
        <source>Servo tick in use: %1 of %2 µs (%3 %)</source>
        <translation>Vom Regeltakt belegt: %1 von %2 µs (%3 %)</translation>
    </message>
    <message>
        <source>Predicted while touching: %1 µs</source>
        <translation>Vorhersage beim Berühren: %1 µs</translation>
    </message>
    <message>
        <source>While touching: %1 µs, predicted %2 µs (%3 %)</source>
        <translation>Beim Berühren: %1 µs, vorhergesagt %2 µs (%3 %)</translation>
    </message>
</context>
<context>
    <name>handwheel::TimeLinePanel</name>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Previous event</source>
        <translation>Voriges Ereignis</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>Nächstes Ereignis</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Über der Zeit</translation>
    </message>
    <message>
        <source>Over distance</source>
        <translation>Über dem Weg</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>No recording</source>
        <translation>Keine Aufzeichnung</translation>
    </message>
    <message>
        <source>Two recordings</source>
        <translation>Zwei Aufzeichnungen</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 von %2 s</translation>
    </message>
    <message>
        <source>, %1 mm</source>
        <translation>, %1 mm</translation>
    </message>
</context>
<context>
    <name>handwheel::TimeTrack</name>
    <message>
        <source>Time line</source>
        <translation>Zeitleiste</translation>
    </message>
</context>
<context>
    <name>handwheel::TimingPage</name>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>Nothing was measured yet.</source>
        <translation>Noch wurde nichts gemessen.</translation>
    </message>
    <message>
        <source>Half within %1, 99 % within %2, some above %3</source>
        <translation>Die Hälfte innerhalb %1, 99 % innerhalb %2, einige über %3</translation>
    </message>
    <message>
        <source>Half within %1, 99 % within %2, all within %3</source>
        <translation>Die Hälfte innerhalb %1, 99 % innerhalb %2, alle innerhalb %3</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Was gezeigt wird</translation>
    </message>
    <message>
        <source>From tick to tick</source>
        <translation>Von Takt zu Takt</translation>
    </message>
    <message>
        <source>How late a tick comes</source>
        <translation>Wie spät ein Takt kommt</translation>
    </message>
    <message>
        <source>Time spent in a tick</source>
        <translation>Zeit in einem Takt</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>The servo loop is not running.</source>
        <translation>Die Servoschleife läuft nicht.</translation>
    </message>
    <message>
        <source>%1 ticks a second, %2 missed so far</source>
        <translation>%1 Takte in der Sekunde, %2 bisher ausgelassen</translation>
    </message>
</context>
<context>
    <name>handwheel::ToolCamera</name>
    <message>
        <source>&amp;View from the tool</source>
        <translation>Ansicht vom &amp;Werkzeug aus</translation>
    </message>
    <message>
        <source>Look from the tool&apos;s centre point along its axis; the view moves with the robot</source>
        <translation>Vom Werkzeugmittelpunkt entlang seiner Achse blicken; die Ansicht bewegt sich mit dem Roboter</translation>
    </message>
</context>
<context>
    <name>handwheel::ToolHost</name>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>move the tip in and out</source>
        <translation>die Spitze hinein- und herausbewegen</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Strg+Rad</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>zoomen</translation>
    </message>
</context>
<context>
    <name>handwheel::ToolKeys</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
</context>
<context>
    <name>handwheel::ToolPanel</name>
    <message>
        <source>This tool has no settings.</source>
        <translation>Dieses Werkzeug hat keine Einstellungen.</translation>
    </message>
    <message>
        <source>Not now: %1.</source>
        <translation>Jetzt nicht: %1.</translation>
    </message>
</context>
<context>
    <name>handwheel::ToolPostRow</name>
    <message>
        <source>Tool in the post</source>
        <translation>Werkzeug im Stahlhalter</translation>
    </message>
    <message>
        <source>&amp;Mount</source>
        <translation>&amp;Einspannen</translation>
    </message>
    <message>
        <source>Mounts another tool on this side of the post, or a drill in the tailstock</source>
        <translation>Spannt ein anderes Werkzeug auf dieser Seite des Stahlhalters ein, oder einen Bohrer im Reitstock</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>%1, in the tailstock</source>
        <translation>%1, im Reitstock</translation>
    </message>
    <message>
        <source>No tool</source>
        <translation>Kein Werkzeug</translation>
    </message>
</context>
<context>
    <name>handwheel::ToolTableDialog</name>
    <message>
        <source>Tools of the program</source>
        <translation>Werkzeuge des Programms</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Nose radius</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Schneidenlage</translation>
    </message>
    <message>
        <source>Offset X</source>
        <translation>Korrektur X</translation>
    </message>
    <message>
        <source>Offset Z</source>
        <translation>Korrektur Z</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>From the &amp;lathe</source>
        <translation>Von der &amp;Drehmaschine</translation>
    </message>
    <message>
        <source>A nose alone</source>
        <translation>Nur eine Schneidenecke</translation>
    </message>
    <message>
        <source>The tools with the T numbers of the program. With a tool of the lathe, its holder, the tool post and the slide are checked for collisions, too. Tools that are not listed have the nose radius of the panel.</source>
        <translation>Die Werkzeuge mit den T-Nummern des Programms. Mit einem Werkzeug der Drehmaschine werden auch sein Halter, der Stahlhalter und der Schlitten auf Kollisionen geprüft. Werkzeuge, die nicht aufgeführt sind, haben den Eckenradius aus dem Feld.</translation>
    </message>
    <message>
        <source>Upside down</source>
        <translation>Gewendet</translation>
    </message>
    <message>
        <source>The insert faces the other side than those of the machine do: it cuts with the other of M3 and M4.</source>
        <translation>Die Schneidplatte zeigt zur anderen Seite als die der Maschine: sie schneidet mit dem anderen von M3 und M4.</translation>
    </message>
</context>
<context>
    <name>handwheel::TouchPage</name>
    <message>
        <source>&amp;Snap the device</source>
        <translation>Gerät &amp;fangen lassen</translation>
    </message>
    <message>
        <source>Attract the tip of the device to what a click of the active tool would choose</source>
        <translation>Die Spitze des Geräts zu dem ziehen, was ein Klick des aktiven Werkzeugs wählen würde</translation>
    </message>
</context>
<context>
    <name>handwheel::ViewActions</name>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>&amp;Dunkles Design</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Isometrisch</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>&amp;Vorne</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>Rig&amp;ht</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>&amp;Shaded</source>
        <translation>&amp;Schattiert</translation>
    </message>
    <message>
        <source>Shaded with &amp;edges</source>
        <translation>Schattiert mit &amp;Kanten</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>Dr&amp;ahtgitter</translation>
    </message>
    <message>
        <source>Switch between the light and the dark theme</source>
        <translation>Zwischen hellem und dunklem Design wechseln</translation>
    </message>
    <message>
        <source>Show the whole model</source>
        <translation>Das ganze Modell zeigen</translation>
    </message>
    <message>
        <source>Look from: %1</source>
        <translation>Blick von: %1</translation>
    </message>
    <message>
        <source>L&amp;athe</source>
        <translation>Dreh&amp;maschine</translation>
    </message>
</context>
<context>
    <name>handwheel::ViewCube</name>
    <message>
        <source>View cube</source>
        <translation>Ansichtswürfel</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorne</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Front of the patient (A)</source>
        <translation>Vorderseite des Patienten (A)</translation>
    </message>
    <message>
        <source>Back of the patient (P)</source>
        <translation>Rückseite des Patienten (P)</translation>
    </message>
    <message>
        <source>Right of the patient (R)</source>
        <translation>Rechte Seite des Patienten (R)</translation>
    </message>
    <message>
        <source>Left of the patient (L)</source>
        <translation>Linke Seite des Patienten (L)</translation>
    </message>
    <message>
        <source>Feet of the patient (F)</source>
        <translation>Fußseite des Patienten (F)</translation>
    </message>
    <message>
        <source>Head of the patient (H)</source>
        <translation>Kopfseite des Patienten (H)</translation>
    </message>
</context>
<context>
    <name>handwheel::ViewSettings</name>
    <message>
        <source>Perspective inste&amp;ad of parallel</source>
        <translation>Perspektive st&amp;att parallel</translation>
    </message>
    <message>
        <source>&amp;View cube</source>
        <translation>Ansichts&amp;würfel</translation>
    </message>
    <message>
        <source>What is farther away looks smaller</source>
        <translation>Was weiter weg ist, sieht kleiner aus</translation>
    </message>
    <message>
        <source>The cube in the corner that turns the view</source>
        <translation>Der Würfel in der Ecke, der die Ansicht dreht</translation>
    </message>
    <message>
        <source>&amp;Clip the model</source>
        <translation>Modell s&amp;chneiden</translation>
    </message>
    <message>
        <source>Clip the model by a plane to look inside; the panel “View” positions the plane</source>
        <translation>Das Modell an einer Ebene abschneiden, um hineinzusehen; das Feld „Ansicht“ legt die Ebene fest</translation>
    </message>
    <message>
        <source>&amp;Half section</source>
        <translation>&amp;Halbschnitt</translation>
    </message>
    <message>
        <source>Cut the part through its axis, seen from here, to look into its bores</source>
        <translation>Schneidet das Teil, von hier gesehen, durch seine Achse, um in Bohrungen zu sehen</translation>
    </message>
    <message>
        <source>Only turned parts have an axis.</source>
        <translation>Nur Drehteile haben eine Achse.</translation>
    </message>
</context>
<context>
    <name>handwheel::Viewport</name>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>The 3D view needs an X server, and this session runs on “%1”. Start the program in an X11 session, or in a Wayland session with Xwayland.</source>
        <translation>Die 3D-Ansicht braucht einen X-Server, diese Sitzung läuft aber auf „%1“. Starten Sie das Programm in einer X11-Sitzung oder in einer Wayland-Sitzung mit Xwayland.</translation>
    </message>
    <message>
        <source>The 3D view needs OpenGL 3.2 through an X server (GLX), which this session does not offer. Start the program in an X11 session, or in a Wayland session with Xwayland.</source>
        <translation>Die 3D-Ansicht braucht OpenGL 3.2 über einen X-Server (GLX), was diese Sitzung nicht bietet. Starten Sie das Programm in einer X11-Sitzung oder in einer Wayland-Sitzung mit Xwayland.</translation>
    </message>
    <message>
        <source>The 3D view could not start: the display offers no OpenGL. Check the graphics driver, or whether the X server provides GLX.</source>
        <translation>Die 3D-Ansicht konnte nicht starten: Die Anzeige bietet kein OpenGL. Prüfen Sie den Grafiktreiber und ob der X-Server GLX bereitstellt.</translation>
    </message>
    <message>
        <source>There is not enough memory to draw all of the model.</source>
        <translation>Der Arbeitsspeicher reicht nicht aus, um das ganze Modell zu zeichnen.</translation>
    </message>
</context>
<context>
    <name>handwheel::VolumeUi</name>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>%1 mm³ in voxels of %2 mm. Its surface is closed.</source>
        <translation>%1 mm³ in Voxeln von %2 mm. Die Oberfläche ist geschlossen.</translation>
    </message>
    <message>
        <source>Opened %1: a volume</source>
        <translation>%1 geöffnet: ein Volumen</translation>
    </message>
    <message>
        <source>&amp;Volume</source>
        <translation>&amp;Volumen</translation>
    </message>
    <message>
        <source>New &amp;clay</source>
        <translation>Neue &amp;Tonkugel</translation>
    </message>
    <message>
        <source>Start with a ball of clay to be shaped by hand</source>
        <translation>Mit einer Kugel aus Ton beginnen, die von Hand geformt wird</translation>
    </message>
    <message>
        <source>Shape &amp;clay</source>
        <translation>&amp;Ton formen</translation>
    </message>
    <message>
        <source>Add, carve, smooth and move clay by hand</source>
        <translation>Ton von Hand auftragen, abtragen, glätten und verschieben</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>New &amp;skull</source>
        <translation>Neuer S&amp;chädel</translation>
    </message>
    <message>
        <source>Making the skull</source>
        <translation>Schädel wird erzeugt</translation>
    </message>
    <message>
        <source>Shape clay</source>
        <translation>Ton formen</translation>
    </message>
    <message>
        <source>Starts with a ball of clay. Add, carve and smooth it by hand.</source>
        <translation>Beginnt mit einer Kugel aus Ton. Tragen Sie von Hand Ton auf und ab, und glätten Sie ihn.</translation>
    </message>
    <message>
        <source>Start with a synthetic skull to be drilled, not that of a patient</source>
        <translation>Mit einem künstlichen Schädel zum Bohren beginnen, der von keinem Patienten stammt</translation>
    </message>
    <message>
        <source>This volume is to be drilled, not shaped</source>
        <translation>Dieses Volumen ist zu bohren, nicht zu formen</translation>
    </message>
    <message>
        <source>It is work on an exercise, which measures what the drill takes and nothing else.</source>
        <translation>Es ist die Arbeit an einer Übung, und diese misst nur, was der Bohrer wegnimmt.</translation>
    </message>
    <message>
        <source>Choose Drill (Shift+D).</source>
        <translation>Wählen Sie Bohren (Umschalt+D).</translation>
    </message>
</context>
<context>
    <name>handwheel::VoxelizeQuestion</name>
    <message>
        <source>Make a volume</source>
        <translation>Volumen erzeugen</translation>
    </message>
    <message>
        <source>The volume becomes a document of its own. Whatever is smaller than a voxel is lost.</source>
        <translation>Das Volumen wird ein eigenes Dokument. Was kleiner als ein Voxel ist, geht verloren.</translation>
    </message>
    <message>
        <source>&amp;Make volume</source>
        <translation>Volumen &amp;erzeugen</translation>
    </message>
    <message>
        <source>%1 voxels along the largest extent: %2</source>
        <translation>%1 Voxel entlang der größten Ausdehnung: %2</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>etwa %1 s</translation>
    </message>
    <message>
        <source>by the resolution rule of drilling, at 1 mm/s and 1 kHz</source>
        <translation>nach der Auflösungsregel des Bohrens, bei 1 mm/s und 1 kHz</translation>
    </message>
    <message>
        <source>four to the thickness of a wall</source>
        <translation>vier je Wandstärke</translation>
    </message>
    <message>
        <source>as chosen</source>
        <translation>wie gewählt</translation>
    </message>
    <message>
        <source>Measuring %1</source>
        <translation>%1 wird vermessen</translation>
    </message>
    <message>
        <source>%1 was not copied</source>
        <translation>%1 wurde nicht kopiert</translation>
    </message>
    <message>
        <source>256 to the largest extent</source>
        <translation>256 auf die größte Ausdehnung</translation>
    </message>
</context>
<context>
    <name>handwheel::WorkpieceUi</name>
    <message>
        <source>Opened %1: stock %2</source>
        <translation>%1 geöffnet: Rohteil %2</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>&amp;Workpiece</source>
        <translation>&amp;Werkstück</translation>
    </message>
    <message>
        <source>Stock of %1.</source>
        <translation>Rohteil %1.</translation>
    </message>
    <message>
        <source>&amp;New workpiece</source>
        <translation>&amp;Neues Werkstück</translation>
    </message>
    <message>
        <source>Start with a cylinder to be turned</source>
        <translation>Mit einem Zylinder zum Drehen beginnen</translation>
    </message>
    <message>
        <source>Open the sample s&amp;haft</source>
        <translation>Beispiel-&amp;Welle öffnen</translation>
    </message>
    <message>
        <source>Open the sample shaft for the lathe</source>
        <translation>Beispiel-Welle für die Drehmaschine öffnen</translation>
    </message>
    <message>
        <source>&amp;Turn</source>
        <translation>&amp;Drehen</translation>
    </message>
    <message>
        <source>Cut the turning part by hand with a round tool</source>
        <translation>Das sich drehende Teil von Hand mit einem runden Werkzeug abtragen</translation>
    </message>
    <message>
        <source>It was cut already, so its size is fixed. “Save as” writes STEP, too.</source>
        <translation>Sie wurde schon bearbeitet, ihre Größe steht fest. „Speichern unter“ schreibt auch STEP.</translation>
    </message>
    <message>
        <source>Undo the passes to change the size.</source>
        <translation>Machen Sie die Schnitte rückgängig, um die Größe zu ändern.</translation>
    </message>
    <message>
        <source>It was cut already, so its size is fixed.</source>
        <translation>Es wurde schon bearbeitet, daher steht seine Größe fest.</translation>
    </message>
    <message>
        <source>Turn a sample bar</source>
        <translation>Beispielstange drehen</translation>
    </message>
    <message>
        <source>Opens a sample bar. Cut it to a shaft by hand, save it as STEP.</source>
        <translation>Öffnet eine Beispielstange. Drehen Sie daraus von Hand eine Welle, speichern Sie sie als STEP.</translation>
    </message>
    <message>
        <source>&amp;Lathe</source>
        <translation>Dre&amp;hmaschine</translation>
    </message>
    <message>
        <source>Work the part on a manual lathe with handwheels and levers</source>
        <translation>Das Teil an einer handbedienten Drehmaschine mit Handrädern und Hebeln bearbeiten</translation>
    </message>
    <message>
        <source>Too fast</source>
        <translation>Zu schnell</translation>
    </message>
    <message>
        <source>The feed of this pass was up to %1 mm per revolution; at most %2 is allowed.</source>
        <translation>Der Vorschub dieses Schnitts betrug bis zu %1 mm je Umdrehung; erlaubt sind höchstens %2.</translation>
    </message>
    <message>
        <source>Undo it, and drag more slowly: f at the pointer is the feed.</source>
        <translation>Machen Sie ihn rückgängig, und ziehen Sie langsamer: f am Zeiger ist der Vorschub.</translation>
    </message>
    <message>
        <source>The bar is that of the exercise.</source>
        <translation>Die Stange gehört zur Übung.</translation>
    </message>
    <message>
        <source>It is the bar of the exercise. The panel “Lesson” says what to do; “Turn” and “Lathe” cut it.</source>
        <translation>Es ist die Stange der Übung. Das Feld „Lektion“ sagt, was zu tun ist; „Drehen“ und „Drehmaschine“ bearbeiten sie.</translation>
    </message>
    <message>
        <source>Checking force and power</source>
        <translation>Kraft und Leistung werden geprüft</translation>
    </message>
    <message>
        <source>The motor power of this pass was up to %1 kW; the lathe of the exercise has %2 kW.</source>
        <translation>Die Motorleistung dieses Schnitts betrug bis zu %1 kW; die Drehmaschine der Übung hat %2 kW.</translation>
    </message>
    <message>
        <source>Too heavy a cut</source>
        <translation>Zu schwerer Schnitt</translation>
    </message>
    <message>
        <source>%1 is a program for a lathe</source>
        <translation>%1 ist ein Programm für eine Drehmaschine</translation>
    </message>
    <message>
        <source>A program is opened in the program editor of the workpiece that it turns.</source>
        <translation>Ein Programm wird im Programmeditor des Werkstücks geöffnet, das es dreht.</translation>
    </message>
    <message>
        <source>Open that workpiece first, then the program, or open the program on a new bar.</source>
        <translation>Öffnen Sie zuerst dieses Werkstück, dann das Programm, oder öffnen Sie das Programm an einer neuen Stange.</translation>
    </message>
    <message>
        <source>Open on a new bar</source>
        <translation>An neuer Stange öffnen</translation>
    </message>
    <message>
        <source>Programs (%1)</source>
        <translation>Programme (%1)</translation>
    </message>
    <message>
        <source>The resultant force of this pass was up to %1 N; the lathe of the exercise allows %2 N.</source>
        <translation>Die Zerspankraft dieses Schnitts betrug bis zu %1 N; die Drehmaschine der Übung erlaubt %2 N.</translation>
    </message>
    <message>
        <source>Enter another size in its panel, also as “2in” or “50/2”. “Save as” writes STEP, too.</source>
        <translation>Geben Sie in seinem Bereich ein anderes Maß ein, auch als „2in“ oder „50/2“. „Speichern unter“ schreibt auch STEP.</translation>
    </message>
    <message>
        <source>It is in the report, and lowers the marks. Undo it, and use a smaller depth or feed.</source>
        <translation>Das steht im Bericht und mindert die Punkte. Machen Sie es rückgängig und nehmen Sie weniger Tiefe oder Vorschub.</translation>
    </message>
    <message>
        <source>It is in the report. Undo it, and use a smaller depth or feed.</source>
        <translation>Das steht im Bericht. Machen Sie es rückgängig und nehmen Sie weniger Tiefe oder Vorschub.</translation>
    </message>
    <message>
        <source>Parted off</source>
        <translation>Abgestochen</translation>
    </message>
    <message>
        <source>A piece of %1 mm length has come off at the free end.</source>
        <translation>Am freien Ende ist ein Stück von %1 mm Länge abgefallen.</translation>
    </message>
    <message>
        <source>Its volume is %1 mm³; %2 mm³ stay in the chuck. Dimensions and exported drawings and STEP files are those of the piece.</source>
        <translation>Sein Volumen ist %1 mm³; %2 mm³ bleiben im Futter. Maße sowie ausgegebene Zeichnungen und STEP-Dateien sind die des Stücks.</translation>
    </message>
    <message>
        <source>A piece of %1 mm length has come off.</source>
        <translation>Ein Stück von %1 mm Länge ist abgefallen.</translation>
    </message>
    <message>
        <source>Its volume is %1 mm³; %2 mm³ stay in the chuck. Dimensions and exported drawings and STEP files are still those of the piece at the free end, which came off before.</source>
        <translation>Sein Volumen ist %1 mm³; %2 mm³ bleiben im Futter. Maße und exportierte Zeichnungen und STEP-Dateien sind weiter die des Stücks am freien Ende, das vorher abgefallen ist.</translation>
    </message>
    <message>
        <source>Measuring the part</source>
        <translation>Das Werkstück wird vermessen</translation>
    </message>
</context>
</TS>
