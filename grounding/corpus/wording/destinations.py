"""Productions of destinations, ways to go and results."""

TEXT = """
[onto]
top 6 @stacked : (PP on (NP (NP top/NN) (PP of <reference>)))
on 3 @stacked : (PP on|onto|atop|upon <reference>)
over 0.5 @stacked : (PP over <reference>)
on.stack 2 @stacked : (PP on|onto <stack>)
top.of.stack 2 @stacked : (PP on (NP (NP top/NN) (PP of <stack>)))
the.top 0.5 @stacked : (PP to|on (NP (NP the top/NN) (PP of <stack>)))

[direction]
up 8 : up
down 7 : down
left 8 : left|right/JJ
over 1 : over
forward 2.5 : forward|backward|forwards|backwards|back/RB
upward 0.6 : upward|upwards|downward|downwards
compass 3 @compass : north|south|east|west|northeast|northwest|southeast|southwest/JJ

[path]
direction 3 : (PP <direction>)
measure.direction 8 @distance : (PP <measure> <direction>)
direction.measure 8 @distance : (PP <direction> <measure>)
measure.side 6 @distance : (PP <measure> to (NP the left|right/NN))
measure.your 1 @distance @viewer : (PP <measure> to|toward (NP your|my left|right/NN))
measure.toward 1 @distance : (PP <measure> toward|towards <target.np>)
measure.away 0.7 @distance : (PP <measure> away/RB from <target.np>)
side.measure 1 @distance : (PP to (NP the left|right/NN) <measure>)
slightly 1 : (PP slightly|straight|directly|diagonally/RB <direction>)
joined 3.5 @distance @deep : (PP <path> and|then <path>)
joined.and.then 0.6 @distance @deep : (PP <path> and then/RB <path>)
down.and.to 1.5 : (PP up|down|forward|back/RB and to (NP the left|right/NN))
over.to 0.6 : (PP over to (NP the left|right/NN))
straight 0.6 @distance : (PP straight/RB <direction> <measure>)
over.measure 0.5 @distance : (PP over <measure> to (NP the left|right/NN))
rows 0.3 @distance : (PP up|down (NP a row|column))
by 0.6 @distance : (PP <direction> (PP by <measure>))
times 0.4 : (PP <direction> once|twice/RB)
slightly.side 0.5 : (PP slightly/RB to (NP the left|right/NN))
towards.corner 0.3 : (PP diagonally/RB <direction> (PP toward|towards|to <target.np>))

[target.np]
person 2 @viewer : <person>
reference 4 : <reference>
edge 3 : <edge.np>
corner 1 : <corner.np>
middle 2 : <middle.np>

[destination]
pp 40 : <destination.pp>
back.home 0.5 @history : (SBAR (WHADVP where) (S (NP it) (VP was)))
where.ref 0.3 : (SBAR (WHADVP where) (S <reference> (VP is|was)))
until 0.2 : <until>

[destination.pp]
onto 8 @stacked : <onto>
relation 18 : <relation>
path 14 : <path>
place 6 : <dest.place>
dest.measured 4 @distance : <dest.measured>
in.set 1.5 @arrangement : (PP in|into|to|at <set.spot>)
two.relations 0.8 : (PP <relation> and <relation>)
place.relation 0.6 : (PP <dest.place> and <relation>)
to.where 0.3 @history : (PP to (SBAR (WHADVP where) (S (NP it) (VP was (PP before/RB)))))
away.from 0.6 : (PP away/RB from <target.np>)
toward 0.7 : (PP toward|towards <target.np>)
with 0.4 : (PP with <references>)

[set.spot]
end 4 @arrangement : (NP (NP the <edge.word>?.6 end) (PP of <set>))
middle 2 @arrangement : (NP (NP the middle|center/NN) (PP of <set>))
set 4 @arrangement : <set>

[dest.place]
corner 6 : (PP to|in|into|at|on|near|toward <corner.np>)
middle 4 : (PP to|in|at|into|near <middle.np>)
side 5 : (PP to|on|over <side.np>)
side.of.table 2 : (PP to|on|at (NP (NP the left|right|far|near|top|bottom|back|front/JJ side) (PP of <table>)))
edge 4 : (PP to|at|on|along|near|against|toward <edge.np>)
area 1.5 : (PP to|in|into <area.np>)
top 3 : (PP to|at|near|toward <top.np>)
all.the.way 1.2 : (PP all/PDT the/DT way/NN to <side.np>)
all.the.way.dir 0.5 : (PP all/PDT the/DT way/NN <direction>)
spot 0.5 : (PP to|in|into (NP the empty|open|next/JJ spot|space|corner|place/NN))
spot.relation 0.5 : (PP to|in|into (NP (NP the|a spot|space|position|place/NN) <relation>))
on.table 1.5 : (PP on|onto <table>)
along 0.3 : (PP along <edge.np>)

[dest.measured]
off.edge 2 @distance : (PP <measure> from|off <edge.np>)
up.from 2 @distance : (PP <measure> <direction> from <reference>)
above.and 2 @distance : (PP (PP <measure> above|below|behind <reference>) and (PP <measure> to \
    (NP the left|right/NN)))
up.and.left.of 2 @distance : (PP (PP <measure> up|down|above|below) and (PP <measure> to (NP \
    (NP the left|right/NN) (PP of <reference>))))
above.and.bare 1 @distance : (PP (PP <measure> above|below) and (PP <measure> left|right/JJ of <reference>))
to.measured 1 @distance : (PP to <measured.relation>)

[measured.relation]
above 3 @distance : (PP <measure> above|below|behind <reference>)
left 3 @distance : (PP <measure> left|right/JJ of <reference>)
left.of 2 @distance : (PP <measure> to (NP (NP the left|right/NN) (PP of <reference>)))
compass 2 @distance @compass : (PP <measure> \
    north|south|east|west|northeast|northwest|southeast|southwest/JJ of <reference>)

[result]
so.that.it 5 : (SBAR so that/IN (S (NP it) (VP is <result.state>)))
so.it 4 : (SBAR so (S (NP it) (VP <is> <result.state>)))
so.they 0.8 : (SBAR so that/IN (S (NP they) (VP are <result.state>)))
until.it 1 : (SBAR until (S (NP it) (VP is <result.state>)))
forms 1 @arrangement : (SBAR so (S (NP it) (VP forms|makes|creates|completes/VBZ <set.new>)))
to.form 2 @arrangement : (S (VP to/TO (VP make|form|create/VB <set.new>)))
touches 1 : (SBAR so (S (NP it) (VP touches <reference>)))
forming 0.8 @arrangement : (S (VP forming|making|creating/VBG <set.new>))
leaving 0.4 @distance : (S (VP leaving/VBG <measure> (PP between <references>)))
sharing 0.5 : (S (VP sharing/VBG (NP its|the <edge.word> edge|side) (PP with <reference>)))
touching 0.5 : (S (VP touching <reference>))
align 0.4 : (S (VP to/TO (VP align|touch|join/VB <reference>)))
forms.that 0.7 @arrangement : (SBAR so that/IN (S (NP it) (VP forms|makes|creates|completes/VBZ <set.new>)))
aligns 0.7 : (SBAR so that/IN (S (NP it) (VP aligns|lines/VBZ <with.it>)))
its.side 0.7 : (SBAR so that/IN (S (NP its|the <edge.word> edge|side) \
    (VP is (PP aligned|level|flush|parallel with|to <reference>))))
fills 0.3 : (SBAR so that/IN (S (NP it) (VP fills/VBZ (NP the gap|hole|space|corner/NN))))

[result.state]
relation 10 : <relation>
place 3 : <location>
stacked 1 @stacked : (VP stacked <onto>)
aligned 2 : (PP aligned|level|flush|parallel with <reference>)
in.line 2 : (PP in (NP line/NN) with <reference>)
touching 2 : (PP touching <reference>)
closest 0.5 : <closest.pp>
joined 0.7 : (PP <relation> and <relation>)
touching.alone 0.8 : (PP touching)
nearly.touching 0.4 : (PP nearly|almost|just/RB touching)

[until]
reaches 3 : (SBAR until (S (NP it) (VP reaches/VBZ <target.np>)))
touches 4 : (SBAR until (S (NP it) (VP touches|hits/VBZ <reference>)))
is 3 : (SBAR until (S (NP it) (VP is <result.state>)))

[with.it]
plain 1 : (PP with <reference>)
up 1 : (PRT up/RP) (PP with <reference>)
degree 0.6 : (PP horizontally|vertically/RB with <reference>)
"""
