"""Joint and marker names as tools and data sets publish them, and the role that each name means.

A convention is (kind, names, roles). In names and roles ``{S}`` is Left and Right, ``{s}`` left and right, ``{C}`` L
and R, ``{c}`` l and r; a word with any of these stands for both sides. Roles are ``role=NAME`` or ``role=NAME+NAME``.
"""

SIDES = ({"S": "Left", "s": "left", "C": "L", "c": "l"}, {"S": "Right", "s": "right", "C": "R", "c": "r"})

FINGERS = " ".join(
    f"{{S}}Hand{finger}{n}" for finger in ("Thumb", "Index", "Middle", "Ring", "Pinky") for n in "1234"
)
MIXAMO = f"""Hips Spine Spine1 Spine2 Neck Head HeadTop_End {{S}}Shoulder {{S}}Arm {{S}}ForeArm {{S}}Hand {FINGERS}
    {{S}}UpLeg {{S}}Leg {{S}}Foot {{S}}ToeBase {{S}}Toe_End"""
MIXAMO_ROLES = """pelvis=Hips spine=Spine1 chest=Spine2 neck=Neck head=Head {s}_clavicle={S}Shoulder
    {s}_shoulder={S}Arm
    {s}_elbow={S}ForeArm {s}_wrist={S}Hand {s}_hand={S}HandMiddle1 {s}_hip={S}UpLeg {s}_knee={S}Leg {s}_ankle={S}Foot
    {s}_toe={S}ToeBase"""
COLLARS = """Hips Chest Chest2 Chest3 Chest4 Neck Head {S}Collar {S}Shoulder {S}Elbow {S}Wrist {S}Hip {S}Knee {S}Ankle
    {S}Toe"""
COLLARS_ROLES = """pelvis=Hips spine=Chest chest=Chest4 neck=Neck head=Head {s}_clavicle={S}Collar
    {s}_shoulder={S}Shoulder
    {s}_elbow={S}Elbow {s}_wrist={S}Wrist {s}_hip={S}Hip {s}_knee={S}Knee {s}_ankle={S}Ankle {s}_toe={S}Toe"""
FACE = "nose {s}_eye {s}_ear"
COCO = FACE + " {s}_shoulder {s}_elbow {s}_wrist {s}_hip {s}_knee {s}_ankle"
COCO_ROLES = """pelvis=left_hip+right_hip neck=left_shoulder+right_shoulder head=left_ear+right_ear
    {s}_shoulder={s}_shoulder
    {s}_elbow={s}_elbow {s}_wrist={s}_wrist {s}_hip={s}_hip {s}_knee={s}_knee {s}_ankle={s}_ankle"""
SMPL = """pelvis {s}_hip spine1 {s}_knee spine2 {s}_ankle spine3 {s}_foot neck {s}_collar head {s}_shoulder {s}_elbow
    {s}_wrist"""
SMPL_ROLES = """pelvis=pelvis spine=spine1 chest=spine3 neck=neck head=head {s}_clavicle={s}_collar
    {s}_shoulder={s}_shoulder
    {s}_elbow={s}_elbow {s}_wrist={s}_wrist {s}_hip={s}_hip {s}_knee={s}_knee {s}_ankle={s}_ankle {s}_toe={s}_foot"""
PIG = """{C}FHD {C}BHD C7 T10 CLAV STRN RBAK {C}SHO {C}UPA {C}ELB {C}FRM {C}WRA {C}WRB {C}FIN {C}ASI {C}PSI {C}THI
    {C}KNE
    {C}TIB {C}ANK {C}HEE {C}TOE"""
PIG_LEGS_ROLES = (
    """pelvis=LASI+RASI+LPSI+RPSI {s}_hip={C}ASI+{C}PSI {s}_knee={C}KNE {s}_ankle={C}ANK {s}_toe={C}TOE"""
)
PIG_ROLES = f"""{PIG_LEGS_ROLES} chest=T10+STRN neck=C7+CLAV head=LFHD+RFHD+LBHD+RBHD {{s}}_shoulder={{C}}SHO
    {{s}}_elbow={{C}}ELB {{s}}_wrist={{C}}WRA+{{C}}WRB {{s}}_hand={{C}}FIN"""

CONVENTIONS = {
    "CMU and HDM05, ASF": (
        "joint",
        """root {c}hipjoint {c}femur {c}tibia {c}foot {c}toes lowerback upperback thorax lowerneck upperneck head
        {c}clavicle {c}humerus {c}radius {c}wrist {c}hand {c}fingers {c}thumb""",
        """pelvis=root spine=upperback chest=thorax neck=lowerneck head=head {s}_clavicle={c}clavicle
        {s}_shoulder={c}humerus {s}_elbow={c}radius {s}_wrist={c}wrist {s}_hand={c}hand {s}_hip={c}femur
        {s}_knee={c}tibia
        {s}_ankle={c}foot {s}_toe={c}toes""",
    ),
    "CMU, BVH of 31 joints": (
        "joint",
        """Hips {C}HipJoint {S}UpLeg {S}Leg {S}Foot {S}ToeBase LowerBack Spine Spine1 Neck Neck1 Head {S}Shoulder
        {S}Arm
        {S}ForeArm {S}Hand {S}FingerBase {S}HandIndex1 {C}Thumb""",
        """pelvis=Hips spine=Spine1 neck=Neck head=Head {s}_clavicle={S}Shoulder {s}_shoulder={S}Arm
        {s}_elbow={S}ForeArm
        {s}_wrist={S}Hand {s}_hand={S}FingerBase {s}_hip={S}UpLeg {s}_knee={S}Leg {s}_ankle={S}Foot
        {s}_toe={S}ToeBase""",
    ),
    "CMU, BVH for 3ds Max": (
        "joint",
        """Hips {C}HipJoint {S}Hip {S}Knee {S}Ankle {S}Toe lowerback Chest Chest2 lowerneck Neck Head {S}Collar
        {S}Shoulder
        {S}Elbow {S}Wrist {c}hand {C}Fingers {C}Thumb""",
        """pelvis=Hips spine=Chest chest=Chest2 neck=lowerneck head=Head {s}_clavicle={S}Collar
        {s}_shoulder={S}Shoulder
        {s}_elbow={S}Elbow {s}_wrist={S}Wrist {s}_hand={c}hand {s}_hip={S}Hip {s}_knee={S}Knee {s}_ankle={S}Ankle
        {s}_toe={S}Toe""",
    ),
    "CMU, BVH for Daz and Poser": (
        "joint",
        """hip abdomen chest neck head {s}Eye {c}Collar {c}Shldr {c}ForeArm {c}Hand {c}Thumb1 {c}Thumb2 {c}Index1
        {c}Index2
        {c}Mid1 {c}Mid2 {c}Ring1 {c}Ring2 {c}Pinky1 {c}Pinky2 {c}Buttock {c}Thigh {c}Shin {c}Foot""",
        """pelvis=hip spine=abdomen chest=chest neck=neck head=head {s}_clavicle={c}Collar {s}_shoulder={c}Shldr
        {s}_elbow={c}ForeArm {s}_wrist={c}Hand {s}_hand={c}Mid1 {s}_hip={c}Thigh {s}_knee={c}Shin
        {s}_ankle={c}Foot""",
    ),
    "Mixamo": ("joint", MIXAMO, MIXAMO_ROLES, "mixamorig:"),
    "Mixamo in Blender": ("joint", MIXAMO, MIXAMO_ROLES, "mixamorig_"),
    "Mixamo from glTF": ("joint", MIXAMO, MIXAMO_ROLES, "Armature|mixamorig1:"),
    "MotionBuilder, HumanIK": (
        "joint",
        MIXAMO.replace("HeadTop_End", "Reference {S}FingerBase {S}UpLegRoll {S}LegRoll {S}ArmRoll {S}ForeArmRoll"),
        MIXAMO_ROLES.replace("{S}HandMiddle1", "{S}FingerBase"),
        "Character1_",
    ),
    "Xsens MVN, segments": (
        "joint",
        """Pelvis L5 L3 T12 T8 Neck Head {S}Shoulder {S}UpperArm {S}ForeArm {S}Hand {S}UpperLeg {S}LowerLeg {S}Foot
        {S}Toe""",
        """pelvis=Pelvis spine=T12 chest=T8 neck=Neck head=Head {s}_clavicle={S}Shoulder {s}_shoulder={S}UpperArm
        {s}_elbow={S}ForeArm {s}_wrist={S}Hand {s}_hip={S}UpperLeg {s}_knee={S}LowerLeg {s}_ankle={S}Foot
        {s}_toe={S}Toe""",
    ),
    "Xsens MVN, joints": (
        "joint",
        """jL5S1 jL4L3 jL1T12 jT9T8 jT1C7 jC1Head j{S}T4Shoulder j{S}Shoulder j{S}Elbow j{S}Wrist j{S}Hip j{S}Knee
        j{S}Ankle
        j{S}BallFoot""",
        """pelvis=jLeftHip+jRightHip chest=jT9T8 neck=jT1C7 head=jC1Head {s}_clavicle=j{S}T4Shoulder
        {s}_shoulder=j{S}Shoulder {s}_elbow=j{S}Elbow {s}_wrist=j{S}Wrist {s}_hip=j{S}Hip {s}_knee=j{S}Knee
        {s}_ankle=j{S}Ankle {s}_toe=j{S}BallFoot""",
    ),
    "Xsens MVN BVH, 100STYLE, perfume": ("joint", COLLARS, COLLARS_ROLES),
    "OptiTrack Motive, bones": (
        "joint",
        """Hip Ab Chest Neck Head {C}Shoulder {C}UArm {C}FArm {C}Hand {C}Thumb1 {C}Index1 {C}Middle1 {C}Thigh
        {C}Shin {C}Foot
        {C}Toe""",
        """pelvis=Hip spine=Ab chest=Chest neck=Neck head=Head {s}_clavicle={C}Shoulder {s}_shoulder={C}UArm
        {s}_elbow={C}FArm
        {s}_wrist={C}Hand {s}_hand={C}Middle1 {s}_hip={C}Thigh {s}_knee={C}Shin {s}_ankle={C}Foot {s}_toe={C}Toe""",
        "Skeleton 001:",
    ),
    "OptiTrack Motive, Baseline markers": (
        "marker",
        """HeadTop HeadFront HeadSide BackTop BackLeft BackRight Chest WaistLFront WaistRFront WaistLBack WaistRBack
        {C}ShoulderBack {C}ShoulderTop {C}UArmHigh {C}ElbowOut {C}WristOut {C}WristIn {C}HandOut {C}Thigh
        {C}KneeOut {C}Shin
        {C}AnkleOut {C}ToeIn {C}ToeOut {C}Heel""",
        """pelvis=WaistLFront+WaistRFront+WaistLBack+WaistRBack chest=Chest neck=BackTop head=HeadTop+HeadFront
        {s}_shoulder={C}ShoulderTop {s}_elbow={C}ElbowOut {s}_wrist={C}WristOut+{C}WristIn {s}_hand={C}HandOut
        {s}_hip=Waist{C}Front+Waist{C}Back {s}_knee={C}KneeOut {s}_ankle={C}AnkleOut {s}_toe={C}ToeIn+{C}ToeOut""",
    ),
    "Qualisys animation markers": (
        "marker",
        """Head{C} HeadTop HeadFront {C}ShoulderTop {C}ShoulderBack {C}Arm {C}ElbowOut {C}WristOut {C}WristIn
        {C}HandOut
        {C}HandIn Chest SpineTop Back{C} WaistLFront WaistLBack WaistRFront WaistRBack {C}Thigh {C}KneeOut {C}Shin
        {C}AnkleOut
        {C}HeelBack {C}ForefootOut {C}ToeTip {C}ForefootIn""",
        """pelvis=WaistLFront+WaistRFront+WaistLBack+WaistRBack chest=Chest neck=SpineTop head=HeadL+HeadR
        {s}_shoulder={C}ShoulderTop {s}_elbow={C}ElbowOut {s}_wrist={C}WristOut+{C}WristIn
        {s}_hand={C}HandOut+{C}HandIn
        {s}_hip=Waist{C}Front+Waist{C}Back {s}_knee={C}KneeOut {s}_ankle={C}AnkleOut {s}_toe={C}ToeTip""",
        "x_",
    ),
    "Rokoko Newton": (
        "joint",
        """Hips Spine1 Spine2 Spine3 Spine4 Neck Head HeadEnd {S}Shoulder {S}Arm {S}ForeArm {S}Hand {S}Thigh
        {S}Shin {S}Foot
        {S}Toe {S}ToeEnd""",
        """pelvis=Hips spine=Spine1 chest=Spine3 neck=Neck head=Head {s}_clavicle={S}Shoulder {s}_shoulder={S}Arm
        {s}_elbow={S}ForeArm {s}_wrist={S}Hand {s}_hip={S}Thigh {s}_knee={S}Shin {s}_ankle={S}Foot {s}_toe={S}Toe""",
    ),
    "Blender Rigify": (
        "joint",
        """spine spine.001 spine.002 spine.003 spine.004 spine.005 spine.006 pelvis.{C} thigh.{C} thigh.{C}.001
        shin.{C}
        shin.{C}.001 foot.{C} toe.{C} shoulder.{C} upper_arm.{C} upper_arm.{C}.001 forearm.{C} forearm.{C}.001
        hand.{C}
        palm.01.{C} f_middle.01.{C} breast.{C}""",
        """pelvis=spine spine=spine.001 chest=spine.003 neck=spine.004 head=spine.006 {s}_clavicle=shoulder.{C}
        {s}_shoulder=upper_arm.{C} {s}_elbow=forearm.{C} {s}_wrist=hand.{C} {s}_hand=f_middle.01.{C} {s}_hip=thigh.{C}
        {s}_knee=shin.{C} {s}_ankle=foot.{C} {s}_toe=toe.{C}""",
        "DEF-",
    ),
    "Unreal mannequin": (
        "joint",
        """root pelvis spine_01 spine_02 spine_03 clavicle_{c} upperarm_{c} lowerarm_{c} hand_{c} index_01_{c}
        middle_01_{c}
        thumb_01_{c} lowerarm_twist_01_{c} upperarm_twist_01_{c} neck_01 head thigh_{c} calf_{c} calf_twist_01_{c}
        foot_{c}
        ball_{c} thigh_twist_01_{c} ik_foot_root ik_foot_{c} ik_hand_root ik_hand_gun ik_hand_{c}""",
        """pelvis=pelvis spine=spine_01 chest=spine_03 neck=neck_01 head=head {s}_clavicle=clavicle_{c}
        {s}_shoulder=upperarm_{c} {s}_elbow=lowerarm_{c} {s}_wrist=hand_{c} {s}_hand=middle_01_{c} {s}_hip=thigh_{c}
        {s}_knee=calf_{c} {s}_ankle=foot_{c} {s}_toe=ball_{c}""",
    ),
    "VRM and Unity": (
        "joint",
        """hips spine chest upperChest neck head {s}Eye jaw {s}UpperLeg {s}LowerLeg {s}Foot {s}Toes {s}Shoulder
        {s}UpperArm
        {s}LowerArm {s}Hand {s}ThumbProximal {s}IndexProximal {s}MiddleProximal""",
        """pelvis=hips spine=spine chest=upperChest neck=neck head=head {s}_clavicle={s}Shoulder
        {s}_shoulder={s}UpperArm
        {s}_elbow={s}LowerArm {s}_wrist={s}Hand {s}_hand={s}MiddleProximal {s}_hip={s}UpperLeg {s}_knee={s}LowerLeg
        {s}_ankle={s}Foot {s}_toe={s}Toes""",
    ),
    "VRoid": (
        "joint",
        """J_Bip_C_Hips J_Bip_C_Spine J_Bip_C_Chest J_Bip_C_UpperChest J_Bip_C_Neck J_Bip_C_Head J_Adj_{C}_FaceEye
        J_Sec_{C}_Bust1 J_Sec_Hair1_01 J_Sec_Hair1_02 J_Sec_Hair1_03 J_Bip_{C}_Shoulder J_Bip_{C}_UpperArm
        J_Bip_{C}_LowerArm
        J_Bip_{C}_Hand J_Bip_{C}_Middle1 J_Bip_{C}_UpperLeg J_Bip_{C}_LowerLeg J_Bip_{C}_Foot J_Bip_{C}_ToeBase""",
        """pelvis=J_Bip_C_Hips spine=J_Bip_C_Spine chest=J_Bip_C_UpperChest neck=J_Bip_C_Neck head=J_Bip_C_Head
        {s}_clavicle=J_Bip_{C}_Shoulder {s}_shoulder=J_Bip_{C}_UpperArm {s}_elbow=J_Bip_{C}_LowerArm
        {s}_wrist=J_Bip_{C}_Hand {s}_hand=J_Bip_{C}_Middle1 {s}_hip=J_Bip_{C}_UpperLeg {s}_knee=J_Bip_{C}_LowerLeg
        {s}_ankle=J_Bip_{C}_Foot {s}_toe=J_Bip_{C}_ToeBase""",
    ),
    "SMPL": ("joint", SMPL + " {s}_hand", SMPL_ROLES + " {s}_hand={s}_hand"),
    "HumanML3D": ("joint", SMPL, SMPL_ROLES),
    "SMPL-H": ("joint", SMPL + " {s}_index1 {s}_middle1 {s}_thumb1", SMPL_ROLES + " {s}_hand={s}_middle1"),
    "SMPL-X": (
        "joint",
        SMPL + " jaw {s}_eye_smplhf {s}_index1 {s}_middle1 {s}_thumb1",
        SMPL_ROLES + " {s}_hand={s}_middle1",
    ),
    "SMPL, FBX": (
        "joint",
        """root Pelvis {C}_Hip Spine1 {C}_Knee Spine2 {C}_Ankle Spine3 {C}_Foot Neck {C}_Collar Head {C}_Shoulder
        {C}_Elbow
        {C}_Wrist {C}_Hand""",
        """pelvis=Pelvis spine=Spine1 chest=Spine3 neck=Neck head=Head {s}_clavicle={C}_Collar
        {s}_shoulder={C}_Shoulder
        {s}_elbow={C}_Elbow {s}_wrist={C}_Wrist {s}_hand={C}_Hand {s}_hip={C}_Hip {s}_knee={C}_Knee
        {s}_ankle={C}_Ankle
        {s}_toe={C}_Foot""",
        "m_avg_",
    ),
    "Human3.6M, 17 points": (
        "joint",
        "Hip {C}Hip {C}Knee {C}Foot Spine Thorax Neck/Nose Head {C}Shoulder {C}Elbow {C}Wrist",
        """pelvis=Hip spine=Spine chest=Thorax neck=LShoulder+RShoulder head=Head {s}_shoulder={C}Shoulder
        {s}_elbow={C}Elbow
        {s}_wrist={C}Wrist {s}_hip={C}Hip {s}_knee={C}Knee {s}_ankle={C}Foot""",
    ),
    "Human3.6M in MMPose": (
        "joint",
        "root {s}_hip {s}_knee {s}_foot spine thorax neck_base head {s}_shoulder {s}_elbow {s}_wrist",
        """pelvis=root spine=spine chest=thorax neck=neck_base head=head {s}_shoulder={s}_shoulder {s}_elbow={s}_elbow
        {s}_wrist={s}_wrist {s}_hip={s}_hip {s}_knee={s}_knee {s}_ankle={s}_foot""",
    ),
    "Kinect v1": (
        "joint",
        """HipCenter Spine ShoulderCenter Head Shoulder{S} Elbow{S} Wrist{S} Hand{S} Hip{S} Knee{S} Ankle{S}
        Foot{S}""",
        """pelvis=HipCenter spine=Spine neck=ShoulderCenter head=Head {s}_shoulder=Shoulder{S} {s}_elbow=Elbow{S}
        {s}_wrist=Wrist{S} {s}_hand=Hand{S} {s}_hip=Hip{S} {s}_knee=Knee{S} {s}_ankle=Ankle{S} {s}_toe=Foot{S}""",
    ),
    "Kinect v2 and NTU": (
        "joint",
        """SpineBase SpineMid Neck Head Shoulder{S} Elbow{S} Wrist{S} Hand{S} Hip{S} Knee{S} Ankle{S} Foot{S}
        SpineShoulder
        HandTip{S} Thumb{S}""",
        """pelvis=SpineBase spine=SpineMid neck=Neck head=Head {s}_shoulder=Shoulder{S} {s}_elbow=Elbow{S}
        {s}_wrist=Wrist{S}
        {s}_hand=Hand{S} {s}_hip=Hip{S} {s}_knee=Knee{S} {s}_ankle=Ankle{S} {s}_toe=Foot{S}""",
    ),
    "Azure Kinect": (
        "joint",
        """PELVIS SPINE_NAVEL SPINE_CHEST NECK CLAVICLE_LEFT SHOULDER_LEFT ELBOW_LEFT WRIST_LEFT HAND_LEFT
        HANDTIP_LEFT
        THUMB_LEFT CLAVICLE_RIGHT SHOULDER_RIGHT ELBOW_RIGHT WRIST_RIGHT HAND_RIGHT HANDTIP_RIGHT THUMB_RIGHT HIP_LEFT
        KNEE_LEFT ANKLE_LEFT FOOT_LEFT HIP_RIGHT KNEE_RIGHT ANKLE_RIGHT FOOT_RIGHT HEAD NOSE EYE_LEFT EAR_LEFT
        EYE_RIGHT
        EAR_RIGHT""",
        """pelvis=PELVIS spine=SPINE_NAVEL chest=SPINE_CHEST neck=NECK head=HEAD left_clavicle=CLAVICLE_LEFT
        left_shoulder=SHOULDER_LEFT left_elbow=ELBOW_LEFT left_wrist=WRIST_LEFT left_hand=HAND_LEFT left_hip=HIP_LEFT
        left_knee=KNEE_LEFT left_ankle=ANKLE_LEFT left_toe=FOOT_LEFT right_clavicle=CLAVICLE_RIGHT
        right_shoulder=SHOULDER_RIGHT right_elbow=ELBOW_RIGHT right_wrist=WRIST_RIGHT right_hand=HAND_RIGHT
        right_hip=HIP_RIGHT right_knee=KNEE_RIGHT right_ankle=ANKLE_RIGHT right_toe=FOOT_RIGHT""",
    ),
    "COCO, AlphaPose, MoveNet": ("joint", COCO, COCO_ROLES),
    "COCO in Keraal": (
        "joint",
        """Nose LEye REye LEar REar LShoulder RShoulder LElbow RElbow LWrist RWrist LHip RHip LKnee Rknee LAnkle
        RAnkle""",
        """pelvis=LHip+RHip neck=LShoulder+RShoulder head=LEar+REar left_knee=LKnee right_knee=Rknee
        {s}_shoulder={C}Shoulder
        {s}_elbow={C}Elbow {s}_wrist={C}Wrist {s}_hip={C}Hip {s}_ankle={C}Ankle""",
    ),
    "OpenPose, COCO_18 in Keraal": (
        "joint",
        "Nose Neck {c}Shoulder {c}Elbow {c}Wrist {c}Hip {c}Knee {c}Ankle {c}Eye {c}Ear",
        """pelvis=lHip+rHip neck=Neck head=lEar+rEar {s}_shoulder={c}Shoulder {s}_elbow={c}Elbow {s}_wrist={c}Wrist
        {s}_hip={c}Hip {s}_knee={c}Knee {s}_ankle={c}Ankle""",
    ),
    "OpenPose, BODY_25": (
        "joint",
        """Nose Neck {C}Shoulder {C}Elbow {C}Wrist MidHip {C}Hip {C}Knee {C}Ankle {C}Eye {C}Ear {C}BigToe {C}SmallToe
        {C}Heel""",
        """pelvis=MidHip neck=Neck head=LEar+REar {s}_shoulder={C}Shoulder {s}_elbow={C}Elbow {s}_wrist={C}Wrist
        {s}_hip={C}Hip {s}_knee={C}Knee {s}_ankle={C}Ankle {s}_toe={C}BigToe""",
    ),
    "HALPE_26": (
        "joint",
        """Nose {C}Eye {C}Ear {C}Shoulder {C}Elbow {C}Wrist {C}Hip {C}Knee {C}Ankle Head Neck Hip {C}BigToe
        {C}SmallToe
        {C}Heel""",
        """pelvis=Hip neck=Neck head=Head {s}_shoulder={C}Shoulder {s}_elbow={C}Elbow {s}_wrist={C}Wrist
        {s}_hip={C}Hip
        {s}_knee={C}Knee {s}_ankle={C}Ankle {s}_toe={C}BigToe""",
    ),
    "BlazePose": (
        "joint",
        COCO.replace("{s}_eye", "{s}_eye_inner {s}_eye {s}_eye_outer mouth_{s}")
        + " {s}_pinky {s}_index {s}_thumb {s}_heel {s}_foot_index",
        COCO_ROLES + " {s}_hand={s}_index+{s}_pinky {s}_toe={s}_foot_index",
    ),
    "BlazePose in Keraal": (
        "joint",
        """Nose {S}_eye_inner {S}_eye {S}_eye_outer {S}_ear Mouth_{s} {S}_shoulder {S}_elbow {S}_wrist {S}_pinky
        {S}_index
        {S}_thumb {S}_hip {S}_knee {S}_ankle {S}_heel {S}_foot_index""",
        """pelvis=Left_hip+Right_hip neck=Left_shoulder+Right_shoulder head=Left_ear+Right_ear
        {s}_shoulder={S}_shoulder
        {s}_elbow={S}_elbow {s}_wrist={S}_wrist {s}_hand={S}_index+{S}_pinky {s}_hip={S}_hip {s}_knee={S}_knee
        {s}_ankle={S}_ankle {s}_toe={S}_foot_index""",
    ),
    "Keraal, targets of ART": (
        "joint",
        """Right_Forearm Left_Forearm Right_Arm Left_Arm Chest Right_Thigh Left_Thigh Right_Shoulder Left_Shoulder
        Right_Hand
        Left_Hand Right_Foot Left_Foot Hips Head Right_Tibia Left_Tibia""",
        """pelvis=Hips chest=Chest neck=Left_Shoulder+Right_Shoulder head=Head {s}_clavicle={S}_Shoulder
        {s}_shoulder={S}_Arm
        {s}_elbow={S}_Forearm {s}_wrist={S}_Hand {s}_hip={S}_Thigh {s}_knee={S}_Tibia {s}_ankle={S}_Foot""",
    ),
    "Perception Neuron": (
        "joint",
        """Hips {S}UpLeg {S}Leg {S}Foot Spine Spine1 Spine2 Neck Neck1 Head {S}Shoulder {S}Arm {S}ForeArm {S}Hand
        {S}HandThumb1 {S}InHandIndex {S}HandIndex1 {S}InHandMiddle {S}HandMiddle1 {S}InHandRing {S}HandRing1""",
        MIXAMO_ROLES.replace("{s}_toe={S}ToeBase", ""),
        "Robot_",
    ),
    "Bandai Namco": (
        "joint",
        """joint_Root Hips Spine Chest Neck Head Shoulder_{C} UpperArm_{C} LowerArm_{C} Hand_{C} UpperLeg_{C}
        LowerLeg_{C}
        Foot_{C} Toes_{C}""",
        """pelvis=Hips spine=Spine chest=Chest neck=Neck head=Head {s}_clavicle=Shoulder_{C} {s}_shoulder=UpperArm_{C}
        {s}_elbow=LowerArm_{C} {s}_wrist=Hand_{C} {s}_hip=UpperLeg_{C} {s}_knee=LowerLeg_{C} {s}_ankle=Foot_{C}
        {s}_toe=Toes_{C}""",
    ),
    "Daz Genesis 3 and 8": (
        "joint",
        """hip pelvis abdomenLower abdomenUpper chestLower chestUpper neckLower neckUpper head {c}Collar {c}ShldrBend
        {c}ShldrTwist {c}ForearmBend {c}ForearmTwist {c}Hand {c}Carpal1 {c}Mid1 {c}Thumb1 {c}Pectoral {c}ThighBend
        {c}ThighTwist {c}Shin {c}Foot {c}Metatarsals {c}Heel {c}Toe {c}BigToe {c}SmallToe1""",
        """pelvis=pelvis spine=abdomenUpper chest=chestUpper neck=neckLower head=head {s}_clavicle={c}Collar
        {s}_shoulder={c}ShldrBend {s}_elbow={c}ForearmBend {s}_wrist={c}Hand {s}_hand={c}Mid1 {s}_hip={c}ThighBend
        {s}_knee={c}Shin {s}_ankle={c}Foot {s}_toe={c}Toe""",
    ),
    "Daz Genesis 9": (
        "joint",
        """hip pelvis spine1 spine2 spine3 spine4 neck1 neck2 head {c}_shoulder {c}_upperarm {c}_upperarmtwist1
        {c}_forearm
        {c}_forearmtwist1 {c}_hand {c}_mid1 {c}_thumb1 {c}_thigh {c}_thightwist1 {c}_shin {c}_foot {c}_metatarsals
        {c}_toes""",
        """pelvis=pelvis spine=spine1 chest=spine3 neck=neck1 head=head {s}_clavicle={c}_shoulder
        {s}_shoulder={c}_upperarm
        {s}_elbow={c}_forearm {s}_wrist={c}_hand {s}_hand={c}_mid1 {s}_hip={c}_thigh {s}_knee={c}_shin
        {s}_ankle={c}_foot
        {s}_toe={c}_toes""",
    ),
    "3ds Max Biped, CharacterStudio": (
        "joint",
        """Pelvis Spine Spine1 Spine2 Neck Head HeadNub {C}_Clavicle {C}_UpperArm {C}_Forearm {C}_Hand {C}_Finger0
        {C}_Finger1 {C}_Finger2 {C}_Thigh {C}_Calf {C}_Foot {C}_Toe0""",
        """pelvis=Pelvis spine=Spine1 chest=Spine2 neck=Neck head=Head {s}_clavicle={C}_Clavicle
        {s}_shoulder={C}_UpperArm
        {s}_elbow={C}_Forearm {s}_wrist={C}_Hand {s}_hand={C}_Finger2 {s}_hip={C}_Thigh {s}_knee={C}_Calf
        {s}_ankle={C}_Foot
        {s}_toe={C}_Toe0""",
        "Bip001_",
    ),
    "Character Creator": (
        "joint",
        """BoneRoot Hip Pelvis Waist Spine01 Spine02 NeckTwist01 NeckTwist02 Head {C}_Eye {C}_Clavicle {C}_Upperarm
        {C}_Forearm
        {C}_Hand {C}_Mid1 {C}_Thigh {C}_Calf {C}_Foot {C}_ToeBase""",
        """pelvis=Pelvis spine=Spine01 chest=Spine02 neck=NeckTwist01 head=Head {s}_clavicle={C}_Clavicle
        {s}_shoulder={C}_Upperarm {s}_elbow={C}_Forearm {s}_wrist={C}_Hand {s}_hand={C}_Mid1 {s}_hip={C}_Thigh
        {s}_knee={C}_Calf {s}_ankle={C}_Foot {s}_toe={C}_ToeBase""",
        "CC_Base_",
    ),
    "DeepMotion": (
        "joint",
        """hips_JNT spine_JNT spine1_JNT spine2_JNT neck_JNT head_JNT {c}_shoulder_JNT {c}_arm_JNT {c}_forearm_JNT
        {c}_hand_JNT
        {c}_upleg_JNT {c}_leg_JNT {c}_foot_JNT {c}_toebase_JNT""",
        """pelvis=hips_JNT spine=spine1_JNT chest=spine2_JNT neck=neck_JNT head=head_JNT {s}_clavicle={c}_shoulder_JNT
        {s}_shoulder={c}_arm_JNT {s}_elbow={c}_forearm_JNT {s}_wrist={c}_hand_JNT {s}_hip={c}_upleg_JNT
        {s}_knee={c}_leg_JNT
        {s}_ankle={c}_foot_JNT {s}_toe={c}_toebase_JNT""",
    ),
    "AMP humanoid": (
        "joint",
        "pelvis torso head {s}_upper_arm {s}_lower_arm {s}_hand {s}_thigh {s}_shin {s}_foot",
        """pelvis=pelvis spine=torso neck=left_upper_arm+right_upper_arm head=head {s}_shoulder={s}_upper_arm
        {s}_elbow={s}_lower_arm {s}_wrist={s}_hand {s}_hip={s}_thigh {s}_knee={s}_shin {s}_ankle={s}_foot""",
    ),
    "Berkeley MHAD": (
        "joint",
        """Hips spine spine1 spine2 Neck Head {S}Shoulder {S}Arm {S}ArmRoll {S}ForeArm {S}ForeArmRoll {S}Hand {S}UpLeg
        {S}UpLegRoll {S}Leg {S}LegRoll {S}Foot {S}ToeBase""",
        MIXAMO_ROLES.replace("Spine", "spine").replace("{s}_hand={S}HandMiddle1", ""),
    ),
    "UI-PRMD": (
        "joint",
        """waist spine chest neck head head_tip {s}_collar {s}_upper_arm {s}_forearm {s}_hand {s}_upper_leg
        {s}_lower_leg
        {s}_foot {s}_toes""",
        """pelvis=waist spine=spine chest=chest neck=neck head=head {s}_clavicle={s}_collar {s}_shoulder={s}_upper_arm
        {s}_elbow={s}_forearm {s}_wrist={s}_hand {s}_hip={s}_upper_leg {s}_knee={s}_lower_leg {s}_ankle={s}_foot
        {s}_toe={s}_toes""",
    ),
    "Gesture Phase": ("joint", "{c}h h s {c}w", "spine=s head=h {s}_wrist={c}w {s}_hand={c}h"),
    "Ground guide": (
        "joint",
        "{s}_shoulder {s}_elbow {s}_wrist {s}_hip",
        """pelvis=left_hip+right_hip neck=left_shoulder+right_shoulder {s}_shoulder={s}_shoulder {s}_elbow={s}_elbow
        {s}_wrist={s}_wrist {s}_hip={s}_hip""",
    ),
    "Plug-in-Gait": ("marker", PIG, PIG_ROLES),
    "Plug-in-Gait with a subject's name": ("marker", PIG, PIG_ROLES, "Subject 01:"),
    "Plug-in-Gait of the legs": ("marker", "{C}ASI {C}PSI {C}THI {C}KNE {C}TIB {C}ANK {C}HEE {C}TOE", PIG_LEGS_ROLES),
    "Plug-in-Gait with joint centres": (
        "marker",
        PIG + " {C}HJC {C}KJC {C}AJC",
        PIG_ROLES.replace("{C}ASI+{C}PSI", "{C}HJC").replace("{C}KNE", "{C}KJC").replace("={C}ANK", "={C}AJC"),
    ),
    "Vicon FrontWaist": (
        "marker",
        """{C}FHD {C}BHD C7 T10 CLAV STRN RBAC {C}SHO {C}UPA {C}ELB {C}FRM {C}WRA {C}WRB {C}FIN {C}FWT {C}BWT
        {C}THI {C}KNE
        {C}SHN {C}ANK {C}HEE {C}TOE {C}MT5""",
        """pelvis=LFWT+RFWT+LBWT+RBWT chest=T10+STRN neck=C7+CLAV head=LFHD+RFHD+LBHD+RBHD {s}_shoulder={C}SHO
        {s}_elbow={C}ELB {s}_wrist={C}WRA+{C}WRB {s}_hand={C}FIN {s}_hip={C}FWT+{C}BWT {s}_knee={C}KNE
        {s}_ankle={C}ANK
        {s}_toe={C}TOE""",
    ),
    "Helen Hayes, Cortex": (
        "marker",
        """Top.Head Front.Head Rear.Head {C}.Shoulder R.Offset {C}.Elbow {C}.Wrist {C}.ASIS V.Sacral {C}.Thigh
        {C}.Knee
        {C}.Knee.Medial {C}.Shank {C}.Ankle {C}.Ankle.Medial {C}.Heel {C}.Toe""",
        """pelvis=L.ASIS+R.ASIS+V.Sacral neck=L.Shoulder+R.Shoulder head=Top.Head+Front.Head+Rear.Head
        {s}_shoulder={C}.Shoulder {s}_elbow={C}.Elbow {s}_wrist={C}.Wrist {s}_hip={C}.ASIS
        {s}_knee={C}.Knee+{C}.Knee.Medial {s}_ankle={C}.Ankle+{C}.Ankle.Medial {s}_toe={C}.Toe""",
    ),
    "Cleveland Clinic, OpenSim gait2392": (
        "marker",
        """Sternum {C}.Acromium Top.Head {C}.Bicep {C}.Elbow {C}.Wrist.Med {C}.Wrist.Lat {C}.ASIS V.Sacral
        {C}.Thigh.Upper
        {C}.Thigh.Front {C}.Thigh.Rear {C}.Knee.Lat {C}.Knee.Med {C}.Shank.Upper {C}.Shank.Front {C}.Shank.Rear
        {C}.Ankle.Lat
        {C}.Ankle.Med {C}.Heel {C}.Midfoot.Sup {C}.Midfoot.Lat {C}.Toe.Tip {C}.Toe.Lat {C}.Toe.Med""",
        """pelvis=L.ASIS+R.ASIS+V.Sacral chest=Sternum neck=L.Acromium+R.Acromium {s}_shoulder={C}.Acromium
        {s}_elbow={C}.Elbow {s}_wrist={C}.Wrist.Med+{C}.Wrist.Lat {s}_hip={C}.ASIS {s}_knee={C}.Knee.Lat+{C}.Knee.Med
        {s}_ankle={C}.Ankle.Lat+{C}.Ankle.Med {s}_toe={C}.Toe.Tip""",
    ),
    "OpenSim Rajagopal": (
        "marker",
        """{C}ACR {C}ASH {C}PSH C7 CLAV {C}ASI {C}PSI {C}UA1 {C}UA2 {C}UA3 {C}LEL {C}MEL {C}FAsuperior {C}FAradius
        {C}FAulna
        {C}TH1 {C}TH2 {C}TH3 {C}LFC {C}MFC {C}TB1 {C}TB2 {C}TB3 {C}LMAL {C}MMAL {C}CAL {C}TOE {C}MT5""",
        """pelvis=LASI+RASI+LPSI+RPSI neck=C7+CLAV {s}_shoulder={C}ACR {s}_elbow={C}LEL+{C}MEL
        {s}_wrist={C}FAradius+{C}FAulna {s}_hip={C}ASI+{C}PSI {s}_knee={C}LFC+{C}MFC {s}_ankle={C}LMAL+{C}MMAL
        {s}_toe={C}TOE""",
    ),
    "OpenCap and Pose2Sim, augmented": (
        "marker",
        """r.ASIS_study L.ASIS_study r.PSIS_study L.PSIS_study r_knee_study r_mknee_study r_ankle_study r_mankle_study
        r_toe_study r_5meta_study r_calc_study L_knee_study L_mknee_study L_ankle_study L_mankle_study L_toe_study
        L_calc_study L_5meta_study r_shoulder_study L_shoulder_study C7_study r_thigh1_study L_thigh1_study
        r_sh1_study
        L_sh1_study r_lelbow_study r_melbow_study r_lwrist_study r_mwrist_study L_lelbow_study L_melbow_study
        L_lwrist_study L_mwrist_study""",
        """pelvis=L.ASIS_study+r.ASIS_study+L.PSIS_study+r.PSIS_study neck=C7_study
        left_shoulder=L_shoulder_study left_elbow=L_lelbow_study+L_melbow_study
        left_wrist=L_lwrist_study+L_mwrist_study
        left_hip=L.ASIS_study+L.PSIS_study left_knee=L_knee_study+L_mknee_study
        left_ankle=L_ankle_study+L_mankle_study left_toe=L_toe_study
        right_shoulder=r_shoulder_study right_elbow=r_lelbow_study+r_melbow_study
        right_wrist=r_lwrist_study+r_mwrist_study
        right_hip=r.ASIS_study+r.PSIS_study right_knee=r_knee_study+r_mknee_study
        right_ankle=r_ankle_study+r_mankle_study right_toe=r_toe_study""",
    ),
    "CAST and Rizzoli (IOR)": (
        "marker",
        """{C}ASIS {C}PSIS {C}GT {C}LE {C}ME {C}HF {C}TT {C}LM {C}MM {C}CA {C}FM {C}SM {C}VM""",
        """pelvis=LASIS+RASIS+LPSIS+RPSIS {s}_hip={C}GT {s}_knee={C}LE+{C}ME {s}_ankle={C}LM+{C}MM {s}_toe={C}SM""",
    ),
    "Van Sint Jan's landmarks": (
        "marker",
        """SGL {C}_HEAD {C}_SAE CV7 TV10 SJN SXS {C}_HLE {C}_HME {C}_RSP {C}_USP {C}_HM2 {C}_IAS {C}_IPS {C}_FTC
        {C}_FLE
        {C}_FME {C}_FAX {C}_TTC {C}_FAL {C}_TAM {C}_FCC {C}_FM1 {C}_FM2 {C}_FM5""",
        """pelvis=L_IAS+R_IAS+L_IPS+R_IPS neck=CV7+SJN head=L_HEAD+R_HEAD {s}_shoulder={C}_SAE
        {s}_elbow={C}_HLE+{C}_HME
        {s}_wrist={C}_RSP+{C}_USP {s}_hand={C}_HM2 {s}_hip={C}_FTC {s}_knee={C}_FLE+{C}_FME {s}_ankle={C}_FAL+{C}_TAM
        {s}_toe={C}_FM2""",
    ),
    "BMClab": (
        "marker",
        """{C}.ASIS {C}.PSIS {C}.Iliac.Crest {C}.GTR {C}.Knee {C}.HF {C}.TT {C}.Ankle {C}.Heel {C}.MT1 {C}.MT2 {C}.MT5
        {C}.Knee.Medial {C}.Ankle.Medial""",
        """pelvis=L.ASIS+R.ASIS+L.PSIS+R.PSIS {s}_hip={C}.GTR {s}_knee={C}.Knee+{C}.Knee.Medial
        {s}_ankle={C}.Ankle+{C}.Ankle.Medial {s}_toe={C}.MT2""",
    ),
    "MoCap Toolbox": (
        "marker",
        """Head_FL Head_FR Head_BL Head_BR Shoulder_{C} Spine Sternum Hip_FL Hip_FR Hip_BL Hip_BR Elbow_{C}
        Radius_{C} Ulna_{C}
        Finger_{C} Knee_{C} Ankle_{C} Pinkie_{C} BigToe_{C}""",
        """pelvis=Hip_FL+Hip_FR+Hip_BL+Hip_BR chest=Spine+Sternum neck=Shoulder_L+Shoulder_R
        head=Head_FL+Head_FR+Head_BL+Head_BR {s}_shoulder=Shoulder_{C} {s}_elbow=Elbow_{C}
        {s}_wrist=Radius_{C}+Ulna_{C}
        {s}_hand=Finger_{C} left_hip=Hip_FL+Hip_BL right_hip=Hip_FR+Hip_BR {s}_knee=Knee_{C} {s}_ankle=Ankle_{C}
        {s}_toe=BigToe_{C}""",
    ),
    "Qualisys, two sticks": (
        "marker",
        """Head-FL Head-FR Head-B Shoulder-{C} Breastbone Back Hip-FL Hip-FR Hip-BL Hip-BR Elbow-{C} Radius-{C}
        Ulna-{C}
        Knee-{C} Ankle-{C} Toe-{C} Baston-{C}-PU Baston-{C}-TIP""",
        """pelvis=Hip-FL+Hip-FR+Hip-BL+Hip-BR chest=Breastbone+Back neck=Shoulder-L+Shoulder-R
        head=Head-FL+Head-FR+Head-B {s}_shoulder=Shoulder-{C} {s}_elbow=Elbow-{C} {s}_wrist=Radius-{C}+Ulna-{C}
        left_hip=Hip-FL+Hip-BL right_hip=Hip-FR+Hip-BR {s}_knee=Knee-{C} {s}_ankle=Ankle-{C} {s}_toe=Toe-{C}""",
    ),
}  # fmt: skip


def both_sides(words: str) -> list[str]:
    """Write out the words that stand for both sides, each once."""
    written = [word.format(**side) for word in words.split() for side in SIDES]
    return list(dict.fromkeys(written))
