"""Productions of places: sides, corners, edges, middles, and what stands there."""

TEXT = """
[table]
table 10 : (NP the table)
board 2 : (NP the board|grid|screen)
surface 0.7 : (NP the surface|desk|tabletop|area)
picture 0.5 : (NP the page|map|picture|field|plane|floor)

[side.word]
side 8 : left|right/NN
height 2.5 : top|bottom/NN
depth 2 : front|back/NN
compass 1.5 @compass : north|south|east|west/NN

[side.np]
the 10 : (NP the left|right/NN)
the.other 3 : (NP the <side.word>)
far 1.5 : (NP the far left|right/NN)
your 4 @viewer : (NP your left|right/NN)
your.far 0.8 @viewer : (NP your far|immediate left|right/NN)
my 1.5 @viewer : (NP my left|right/NN)
side 4 : (NP the left|right|far|near|other|top|bottom|back|front|opposite/JJ side)
hand.side 1.5 : (NP the right-hand|left-hand side)
your.side 2 @viewer : (NP your left|right side)
your.hand.side 1.2 @viewer : (NP your right-hand|left-hand side)
my.side 0.7 @viewer : (NP my left|right side)
own.side 0.7 @viewer : (NP my|your side)
my.end 0.3 @viewer : (NP (NP my|your end) (PP of <table>))
hand 0.7 @viewer : (NP your left|right/JJ hand)
hand.the 0.2 @viewer : (NP the left|right/JJ hand)

[corner.np]
the 10 : (NP the <corner.word> corner)
of.table 2.5 : (NP (NP the <corner.word> corner) (PP of <table>))
your 0.7 @viewer : (NP your <corner.word> corner)
bare 0.6 : (NP the corner)

[corner.word]
height 8 : <high> left|right
depth 3 : back|front|far|near/JJ left|right
compass 2 @compass : northeast|northwest|southeast|southwest|northeastern|southwestern|northwestern
one 1.5 : left|right|top|bottom|far
hand 0.5 : <high> right-hand|left-hand

[edge.np]
the 8 : (NP the <edge.word> edge|end)
of.table 3 : (NP (NP the <edge.word>?.8 edge) (PP of <table>))
middle.of 1 : (NP (NP the middle|center/NN) (PP of (NP the <edge.word> edge|side)))
bare 0.7 : (NP the edge)

[edge.word]
side 5 : left|right
depth 3 : front|back|far|near|rear/JJ
height 3 : top|bottom|upper|lower
compass 1 @compass : north|south|east|west

[middle.np]
bare 5 : (NP the middle|center/NN)
of.table 3 : (NP (NP the middle|center/NN) (PP of <table>))
very 0.6 : (NP the very|exact/JJ middle|center/NN)
place.middle 1 : (NP the left|right|top|bottom|upper|lower/JJ middle|center/NN)
top.middle.of 0.6 : (NP (NP the top|bottom|left|right/JJ middle|center/NN) (PP of <table>))

[area.np]
quadrant 3 : (NP the <corner.word> quadrant)
half 2 : (NP the left|right|top|bottom|upper|lower|front|back half/NN)
section 1.5 : (NP the <place.word> section|part|area|portion|region)
of.table 2 : (NP (NP the <place.word> quadrant|part|half/NN|section|area|portion|region) (PP of <table>))

[top.np]
plain 4 : (NP the top|bottom|front|back/NN)
of.table 3 : (NP (NP the top|bottom|front|back/NN) (PP of <table>))
very 1.2 : (NP the very top|bottom|back|front/NN)
very.of 0.5 : (NP (NP the very top|bottom|back|front/NN) (PP of <table>))
far 0.5 : (NP the far back/NN)

[location]
side 8 : (PP on|to|at|in <side.np>)
side.of.table 3 : (PP on|at|in (NP (NP the left|right|far|near|top|bottom|back|front|upper|lower/JJ \
    side) (PP of <table>)))
left.of.table 1 : (PP on|at|to (NP (NP the <side.word>) (PP of <table>)))
toward 0.6 : (PP toward|towards <side.np>)
corner 5 : (PP in|at|on|near|from <corner.np>)
edge 3 : (PP at|on|near|along|by|against <edge.np>)
middle 3 : (PP in|at|near <middle.np>)
area 2 : (PP in|on|from <area.np>)
top 3 : (PP at|on|in|near|toward|towards <top.np>)
furthest.to 3.5 : (PP furthest|farthest to <side.np>)
furthest.on 1 : (PP furthest|farthest on|at <side.np>)
furthest.compass 0.4 @compass : (PP furthest|farthest (NP north|south|east|west/NN))
further.to 0.4 : (PP further|farther to <side.np>)
compass 1 @compass : (PP in|to|at (NP the <compass.noun>))
compass.corner 0.3 @compass : (PP in|at (NP the <compass.noun> corner))
alone 2 : (PP by (NP itself))
all.alone 0.6 : (PP all/DT by (NP itself))
on.its.own 0.5 : (PP on (NP its own/JJ))
on.table 0.6 : (PP on <table>)
most.side 0.3 @loose : (PP most|more/RBS to <side.np>)

[compass.noun]
word 1 @compass : north|south|east|west|northeast|northwest|southeast|southwest/NN

[from.side]
side 8 : (PP from (NP the left|right|top|bottom|front|back/NN))
far 1 : (PP from (NP the far left|right/NN))
compass 0.5 @compass : (PP from (NP the north|south|east|west/NN))
your 1.5 @viewer : (PP from|on (NP your left|right/NN))
end 2 : (PP from <edge.np>)
corner 1 : (PP from <corner.np>)
on 0.7 : (PP to|on (NP the left|right/NN))
in.from 0.4 : (PP in from (NP the left|right|top|bottom/NN))
down.from 0.4 : (PP down|up from (NP the top|bottom/NN))
"""
