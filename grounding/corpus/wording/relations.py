"""Productions of relations to persons and other blocks, and of all that says where something is."""

TEXT = """
[person]
you 10 @viewer : (NP you)
me 6 @viewer : (NP me)
yourself 0.7 @viewer : (NP yourself|myself)
robot 1 @viewer : (NP the robot)
my.side 0.5 @viewer : (NP my|your side|end|position/NN)
us 0.2 @viewer : (NP where/WRB you/PRP are/VBP)

[reference]
base 10 : (NP <base>)
indefinite 2.5 : (NP a|another <color>?.8 <noun>)
where 3 @deep : (NP (NP <base>) <where>)
ranked.in 0.8 @deep @arrangement : (NP (NP the <rank> <noun>) <in.set>)
that 0.6 @deep : (NP (NP <base>) <that>)
set 2 @deep @arrangement : <set>
stack 3 @stacked : <stack>
number 1 : (NP <number> <color>?.6 <nouns>)
it 0.3 @history : (NP it)
edge 0.5 : <edge.np>
corner 0.5 : <corner.np>
middle 0.4 : <middle.np>
blocks 1.5 @deep : <blocks>

[references]
counted 5 : (NP the|those <number> <color>?.6 <nouns>)
number 2 : (NP <number> <color>?.6 <nouns>)
two 7 @deep : (NP <reference> and <reference>)
two.briefly 3 : (NP (NP <base>) and (NP <base>))
colors 1.5 @color : (NP the|a <color> and <color> <nouns>)
both 0.6 : (NP both <color>?.4 <nouns>)
two.numbers 0.7 @color : (NP (NP <number> <color> <nouns>) and (NP one|two/CD <color> <nouns>))
others 0.6 : (NP the|two other <number>?.3 <color>?.6 <nouns>)
sets 1 @arrangement : (NP the <number>?.6 rows|columns|towers|stacks|groups|clusters)
same.kind 0.5 : (NP <bases>)
persons 0.3 @viewer : (NP (NP you|me) and <reference>)
number.and.one 1.5 : (NP (NP <number> <color>?.8 <nouns>) and (NP a|one/CD <color>?.8 <noun>))
one.and.number 0.5 : (NP (NP a|one/CD <color>?.8 <noun>) and (NP <number> <color>?.8 <nouns>))
two.indefinite 2 : (NP (NP a <color>?.8 <noun>) and (NP a|another <color>?.8 <noun>))

[of.direction]
left 8 : (PP to (NP (NP the left|right/NN) (PP of <reference>)))
left.side 1.2 : (PP on (NP (NP the left|right/JJ side) (PP of <reference>)))
side.of 0.6 : (PP on (NP (NP the other|far|near|opposite/JJ side) (PP of <reference>)))
bare.left 2 : (PP left|right/JJ of <reference>)
front 4 : (PP in (NP (NP front/NN) (PP of <reference>)))
in.the.front 0.3 @loose : (PP in (NP (NP the front/NN) (PP of <reference>)))
corner.of 0.5 : (PP to (NP (NP the <high> left|right/NN) (PP of <reference>)))
compass 1.5 @compass : (PP north|south|east|west|northeast|northwest|southeast|southwest/JJ of <reference>)
to.the.compass 0.7 @compass : (PP to (NP (NP the <compass.noun>) (PP of <reference>)))

[prep.direction]
behind 4 : (PP behind <reference>)
above 4 : (PP above|over <reference>)
below 3.5 : (PP below|under|beneath|underneath <reference>)
back.of 0.5 : (PP in (NP (NP back/NN) (PP of <reference>)))
beyond 0.3 : (PP beyond|past <reference>)

[degree]
directly 6 : directly|immediately|right/RB
just 3 : just/RB
slightly 1 : slightly|almost/RB
diagonally 0.7 : diagonally/RB
just.slightly 0.2 : just slightly
exactly 0.4 : exactly|nearly/RB

[relation]
of.direction 8 : <of.direction>
prep.direction 8 : <prep.direction>
directly.prep 3.5 : (PP <degree> behind|above|below|under|beneath|underneath|beside|over|between <reference>)
directly.next 1 : (PP <degree> next/JJ to <reference>)
directly.left 1.5 : (PP <degree> to (NP (NP the left|right/NN) (PP of <reference>)))
directly.bare.left 0.7 : (PP <degree> left|right/JJ of <reference>)
directly.front 1.5 : (PP <degree> in (NP (NP front/NN) (PP of <reference>)))
directly.compass 0.6 @compass : (PP <degree> north|south|east|west/JJ of <reference>)
next.to 6 : (PP next/JJ to <reference>)
right.next.to 0.5 : (PP right|directly/RB next/JJ to <reference>)
beside 3 : (PP beside|by|near|against|alongside <reference>)
close.to 1.5 : (PP close|adjacent|parallel|opposite/JJ to <reference>)
touching 4 : (PP touching <reference>)
touching.both 2.2 : (PP touching <references>)
touching.both.and 0.4 @deep : (PP touching (NP both/DT <reference> and <reference>))
facing 0.3 : (PP facing <reference>)
on.top 2.5 @stacked : (PP on (NP (NP top/NN) (PP of <reference>)))
on 1 @stacked : (PP on|atop|upon <reference>)
between 5 : (PP between <references>)
in.between 2.5 : (PP in between <references>)
middle.of 1 : (PP in (NP (NP the middle|center/NN) (PP of <references>)))
surrounded 3 : (PP surrounded by <references>)
surrounded.sides 0.4 : (PP surrounded (PP on (NP two|three/CD sides)) by <references>)
joined 0.8 : (PP (PP above|below|behind) and (PP to (NP (NP the left|right/NN) (PP of <reference>))))
joined.front 0.4 : (PP (PP in (NP front/NN)) and (PP to (NP (NP the left|right/NN) (PP of <reference>))))
in.line 0.8 : (PP in (NP line/NN) with <reference>)
aligned 0.3 : (PP aligned|level|flush with <reference>)
away.from 0.4 : (PP away|separated|isolated/VBN from <references>)
far.from 0.2 : (PP far/JJ from <reference>)
measured.of 2 @distance : (PP <measure> to (NP (NP the left|right/NN) (PP of <reference>)))
measured.bare 1 @distance : (PP <measure> left|right/JJ of <reference>)
measured.prep 2 @distance : (PP <measure> above|below|behind|from <reference>)
measured.front 0.6 @distance : (PP <measure> in (NP (NP front/NN) (PP of <reference>)))
measured.compass 0.6 @distance @compass : (PP <measure> north|south|east|west|northeast|southwest/JJ of <reference>)
measured.away 0.6 @distance : (PP <measure> away/RB from <reference>)
to.its.left 0.4 @history : (PP to (NP its|their left|right/NN))
diagonal.to 0.5 : (PP diagonal to <reference>)
located 1 @deep : (PP located|situated|positioned|standing|sitting <relation>)
kitty.corner 0.3 @loose : (PP kitty|caddy/NN corner/NN to|from <reference>)
halfway 0.7 : (PP halfway|midway/RB between <references>)
same.row 0.7 @arrangement : (PP in (NP the same row|column|line) as <reference>)
across 0.3 : (PP across from <reference>)
around 0.2 : (PP around|among <references>)
corner.touching 0.3 : (PP touching (NP (NP the corner|edge|side) (PP of <reference>)))
of.edge 0.6 : (PP at|against (NP (NP the <edge.word> side|edge) (PP of <reference>)))
aligned.how 0.4 : (PP horizontally|vertically/RB aligned with <reference>)
in.direct.line 0.2 : (PP in (NP a|the direct|straight/JJ line) with <reference>)

[measure]
number 8 @distance : (NP <number> <units>)
one 5 @distance : (NP one/CD|a|1 <unit>)
half 2 @distance : (NP half/PDT a/DT <unit>)
half.unit 1 @distance : (NP one|a half/JJ <unit>)
and.half 1 @distance : (NP <number> and a/DT half/NN <units>)
one.and.half 0.5 @distance : (NP one/CD and a/DT half/NN <units>)
decimal 0.5 @distance : (NP 1.5|2.5/CD <units>)
about 1 @distance : (NP about|approximately|almost/RB <number> <units>)
few 1 @distance : (NP a few|couple/JJ <units>)
couple.of 0.3 @distance : (NP (NP a couple/NN) (PP of (NP <units>)))
bare 1 @distance : (NP <number>)
bit 0.7 @distance : (NP a bit/NN)
little 0.4 @distance : (NP a little/JJ bit/NN)
more 0.5 @distance : (NP one|two more/JJR <units>?.5)
another 0.3 @distance : (NP another <unit>)
quarter 0.2 @distance : (NP a quarter/NN <unit>)
very.little 0.2 @distance : (NP an inch/NN)

[unit]
space 8 @distance : space
block 4 @distance : block|box|cube
length 3 @distance : block|cube|box length|width|space
others 1.5 @distance : spot|square|position|unit|tile|place/NN

[units]
spaces 8 @distance : spaces
blocks 4 @distance : blocks|boxes|cubes
lengths 3 @distance : block|cube|box lengths|widths|spaces
others 1.5 @distance : spots|squares|units|tiles|rows|columns

[closest.pp]
to.person 6 @viewer : (PP closest|nearest|closer|nearer to <person>)
to.reference 4 @deep : (PP closest|nearest|closer to <reference>)
to.edge 2.5 : (PP closest|nearest to <edge.np>)
to.corner 1.5 : (PP closest|nearest to <corner.np>)
to.middle 1 : (PP closest|nearest to <middle.np>)
to.side 1 : (PP closest|nearest to <side.np>)
nearest.you 1 @viewer : (PP nearest|closest <person>)
farthest.person 3.5 @viewer : (PP farthest|furthest|farther from <person>)
farthest.away.person 2.5 @viewer : (PP farthest|furthest|farther|further away/RB from <person>)
farthest.away 1 : (PP farthest|furthest away/RB)
farthest.reference 1 @deep : (PP farthest|furthest away/RB from <reference>)
nth.closest.person 1 @viewer : (PP second|third|fourth closest|nearest to <person>)
nth.closest 1 @deep : (PP second|third|fourth closest|nearest to <reference>)
nth.farthest 0.7 @viewer : (PP second|third|fourth farthest|furthest from <person>)
most.close 0.2 @loose @viewer : (PP most close|near/JJ to <person>)

[nth.pp]
from 6 : (PP second|third|fourth|first|fifth|2nd|3rd/JJ from (NP the left|right|top|bottom|front|back/NN))
from.edge 1.5 : (PP second|third|fourth|first/JJ from <edge.np>)
from.corner 0.5 : (PP second|third|first/JJ from <corner.np>)
in 0.4 : (PP second|third/JJ in (NP line/NN))
number.from 0.7 : (PP two|three|four/CD from (NP the left|right|top|bottom/NN))
to.side 0.4 : (PP second|third furthest|farthest to <side.np>)

[view.pp]
from 6 @viewer : (PP from (NP your|my perspective|view|viewpoint|position|side/NN))
point.of.view 1.5 @viewer : (PP from (NP (NP your|my point) (PP of (NP view))))

[where]
place 18 : <location>
relation 16 @deep : <relation>
relation.brief 4 : <relation.brief>
closest 12 : <closest.pp>
nth 4 : <nth.pp>
view 1.2 @viewer : <view.pp>
in.set 3 @arrangement @deep : <in.set>
two.places 1 : (PP <location> and <location>)
place.and.closest 0.5 : (PP <location> and <closest.pp>)
relation.and.place 0.4 @deep : (PP <relation> and <location>)

[relation.brief]
next.to 3 : (PP next/JJ to (NP <base>))
prep 4 : (PP behind|above|below|beside|under|near|by (NP <base>))
front 2 : (PP in (NP (NP front/NN) (PP of (NP <base>))))
front.of.person 2 @viewer : (PP in (NP (NP front/NN) (PP of <person>)))
directly.front.of.person 0.7 @viewer : (PP <degree> in (NP (NP front/NN) (PP of <person>)))
left 3 : (PP to (NP (NP the left|right/NN) (PP of (NP <base>))))
touching 2 : (PP touching (NP a|the <color>?.8 <noun>))
"""
