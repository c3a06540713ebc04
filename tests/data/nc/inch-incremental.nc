; incremental, inches, lower case
g20 g90
g0 x1 y1 z.5
g91
g1 z-.6 f10
x.25 f15
y.25
g2 x.25 y.25 i.25 j0
g1 x1.5
g3 x.5 y.5 r.5
x-.5 y.5 r.5
g1 x-1.5
y-1.5
g90
g0 z.5
m2
