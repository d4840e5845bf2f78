"""Common English words that are no misspelling of any other, though no treebank of instructions has them."""

from __future__ import annotations

COMMON = frozenset(
    """
    ability able about above accept across act action actually add after again against age ago agree ahead air alarm
    alive allow almost alone along already also although always am amber among amount an and angle angry animal ankle
    another answer any anyone anything apple apply apron arch are area arm army around arrive arrow art as ask at
    attach away axe baby backpack bacon bad badge bag bake balance ball balloon banana band bank banner bar bare bark
    barrel base basic basin basket bat bath battery be beach bead beads beaker beam bean bear beat bed bee been beer
    beet before began begin behave beige being bell belt bench bend best better bike bill bin bird bit bite blade
    blame blank blanket blast blend blind blow board boat body boil bold bolt bomb bone book boot boss both bother
    bottle bottles bound bow bowl boy bracket brain brake branch brass brave bread break breath bridge bright broad
    broke bronze broom brother brought brush bubble bucket bug build bulb bulk bull bump bun bundle burger burn bus
    bush but butter button buy cab cabin cable cage cake calf call calm came camera camp can candle candy cane cannot
    cap cape car card care carpet carrot carry cart case cash cast castle cat catch cause cave cell chain chair chalk
    chance change charge chart check cheek cheese chef cherry chess chest chew chick chicken child chin chip chips
    choice circuit city claim clam clamp class clay clean clerk clever click cliff climb clip clock cloth cloud clown
    club coal coat cod code coffee coil coin coins cold comb come comic cone cook cookie cool copper copy cord core
    cork corn cost cotton couch cough could count country course court cover cow crab crack crane crate crawl crayon
    crazy cream crib crisp crop cross crow crowd crown crumb crush cry cub cup cups curl cut cycle dad daily dance
    danger dark dart data date day dead deal dear deck deep deer den depth desk did die different dig dime dine dinner
    dirt disc dish disk dive do dock does dog doll dollar dome done donut door dot double doubt dough down draft drain
    draw drawer dream dress drill drink drive drove drum dry duck dull dumb during dust duty each ear early earn earth
    ease easel east easy eat egg eight either else empty engine enjoy enter equal eraser error even evening ever every
    exact exit extra eye fabric face fact fair fake fall false fame family fan fancy far farm fast fat father fear
    feather feel feet fell felt fence few field fight figure file film final fine finger fire fish fist fit fix flag
    flame flash flask flat flesh float flour flower flute fly foam fog foil fold follow food fool foot for force
    forget fork fort forty found frame free fresh friend frog fruit fuel full fun funnel fur gain game gap garage
    garden garlic gas gate gave gear gem gentle giant gift gin girl give glad glass globe glove glue go goal goat god
    gone good goose got gown grade grain grand grape grapes grass grave great grill grin grip groove ground grow guard
    guess guest guide guitar gum gun guy had hair half hall ham hammer hand handle hang happen happy hard has hat
    hatch have hay he head heap hear heart heat heavy heel hello helmet help hen her here hero hers hey hide hill him
    hinge hint hip his hit hive hog hole hollow home honey hood hook hoop hop hope horn horse hose hot hour house how
    huge hundred hunt hurt hut ice idea if ill imagine in inch indeed ink insect instead iron island it item ivory
    jacket jam jar jaw jeans jelly jet jewel job joke joy jug juice jump just kettle key keyboard keys kick kid kind
    king kit kite kitten knee knife knob knock knot know label lace lack ladder lady lake lamb lamp land lap laptop
    large laser late laugh law lawn lay lazy lead leaf learn leather leave leg lego lemon lend lens less let letter
    lettuce lever lid lie life lift light like limb lime lion lip list listen live liver load loaf loan lock log long
    loop lose lot loud love lucky lump lunch machine mad made magnet mail main make male man many map marble march
    mark marker maroon mask mass mast mat match math maybe meal mean meat medal meet melon melt men mend menu mess
    metal meter mice might mile milk mill mind mine mint mirror miss mix model mom money monkey month mood moon mop
    more morning mother motor mouse mouth movie much mud muffin mug mum muscle music must nail name napkin narrow
    nature navy neat neck need needle nerve nest net never news nice nickel night nine no noise none nor nose not note
    notebook nothing now nurse nut oak oar oat object ocean odd off office often oil old olive on once onion only open
    or oral orbit order ounce our out oven over owl own pack pad page paint pan panda panel pants paper park part
    party pass past pasta paste path paw pay pea peach pear pearl peel peg pen pencil penny people pepper perhaps pet
    petal phone photo piano pie pig pillar pillow pin pine pipe pistol pit pizza plain plan plane planet plank plant
    plastic plate play plea plug plum plus pocket poem point poke pole pond pool poor pop pork port post pot potato
    pound powder power press pretty price prince print prize proof proud puck pull pump pumpkin punch pup puppet puppy
    pure purse puzzle quack quail queen quick quiet quilt quit quite quiz rabbit race rack radio rag rail rain raisin
    ramp ran ranch range rare rash rat rate raw ray razor reach read real reason rest rib ribbon rice rich rid ride
    rifle right ripe rise river road roast robe rock rod role roll roof room root rope rose rough round rub rubber
    rude rug rule ruler run rush rust sack sad safe sail salad salt same sand sandal sauce saucer save saw say scale
    scarf school scissors score scrap screw sea seal seat seed seem seen self sell send sent seven sew shade shadow
    shaft shake shall share shark sharp shave she shed sheep sheet shelf shell shin ship shirt shock shoe shoes shop
    shore short shot should shout shovel show shrimp sick sign silk silly silver sing sink sir sister sit six size
    skate skill skin skip skirt skull sky sleep sleeve slept slice slip slot slow smart smell smile smoke smooth snack
    snail snake snap snow so soap sock socks soda sofa soft soil sold some son song soon sort sound soup sour spade
    spare spark speak spear speck speed spell spice spider spin spine spoke sponge spoon spoons sport spray spring spy
    stage stain stair stake stamp star start state station steak steal steam steel stem step stew stick sticks still
    stone stones stool stop store storm story stove strap straw stream street strike string strip strong student stuff
    such sugar suit sun super sure sweet swim swing switch sword table tack tail tale talk tall tan tank tap tape tart
    task taste tax tea teal team tear teeth tell ten tent term test text thank thanks them then these they thick thief
    thin thing think this thorn those thread three throat throw thumb ticket tie tiger tight time tin tiny tip tire
    toad toast today toe told tomato tone tongue too took tool tools tooth torch total towel town toy toys track trade
    trail train trap trash tray treat tree trick trip truck true trunk trust try tub tube tulip tuna turn turtle
    twenty twig twin type ugly uncle under until up upset urn us use vase vast veil vent verb very vest vine violin
    voice vote wagon waist wait walk wall wallet wand want war warm wash washer waste watch water wax way we weak wear
    weather web wedge week weigh well went were wet whale what wheat wheel when where whip whisk white who whole why
    wide wife wild will win wind window wine wing wings winter wipe wire wise wish with wolf woman won wood wooden
    wool word work world worm worn worth would wrap wrench wrist write wrong yard yarn year yes yet yogurt young your
    zebra zinc zipper zone zoo
    """.split()
)
