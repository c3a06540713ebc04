(Exported by FreeCAD)
(Post Processor: linuxcnc_post)
(Output Time:2024-01-01 12:00:00.000000)
(begin preamble)
G17 G54 G40 G49 G80 G90
G21
(begin operation: T1: 10mm Endmill)
(machine units: mm/min)
(TC: T1: 10mm Endmill)
M5
M6 T1
G43 H1
M3 S5000
(finish operation: T1: 10mm Endmill)
(begin operation: Profile)
(machine units: mm/min)
(Profile)
(Compensated Tool Path. Diameter: 10.0)
G0 Z15.000
G0 X-10.000 Y-5.000
G0 Z13.000
G1 X-10.000 Y-5.000 Z-2.000 F300.000
G3 X-5.000 Y0.000 Z-2.000 I0.000 J5.000 F600.000
G1 X-5.000 Y20.000 Z-2.000 F600.000
G2 X0.000 Y25.000 Z-2.000 I5.000 J0.000 F600.000
G1 X60.000 Y25.000 Z-2.000 F600.000
G3 X65.000 Y30.000 Z-2.000 I0.000 J5.000 F600.000
G1 X65.000 Y60.000 Z-2.500 F600.000
G0 Z15.000
(finish operation: Profile)
(begin postamble)
M05
G17 G54 G90 G80 G40
M2
